// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "surfmesh/core/observer.hh"

namespace surfmesh::python {

/// Run `body` on a thread of its own without the GIL, while the calling thread, which has the GIL
/// and gives it up between, looks after signals (Ctrl-C) and calls `progress(stage, done, total,
/// elements)`; None is no function.
///
/// A signal handler or function that raises ends the run, and so does one that returns False or
/// NumPy's: `body` is asked to stop by the observer, and what was raised goes on from here. Of news
/// that come faster than the function takes them, the last of each stage is told.
/// Pre      `body` uses nothing of Python
/// Throws   what `body` and `progress` throw; Cancelled after False, even if `body` had ended
void run_watched(const pybind11::object& progress, const std::function<void(Observer&)>& body);

}  // namespace surfmesh::python
