// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace surfmesh::detail {

/// Tells the thread sanitizer what it cannot see: that oneTBB, which is not built with it, lets all
/// before a call that is shared happen before its parts, and these before what follows the call.
/// Without the sanitizer, it does nothing.
class HappensBefore {
 public:
  /// All that this thread has done so far happens before what follows an after() of any thread.
  void before() {
#ifdef __SANITIZE_THREAD__
    __tsan_release(this);
#endif
  }

  void after() {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(this);
#endif
  }
};

}  // namespace surfmesh::detail
