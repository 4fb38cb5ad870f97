// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// The allocator of the whole program, of the C library's malloc and of all that stands on it
/// (operator new, Eigen, oneTBB, expat, zlib), which counts and, where it is told to, fails.
namespace surfmesh::testing {

/// Let the allocation fail that is the given one from now on, counted from 1.
void fail_at(long number);

/// Let all allocations fail by which the program would have so many bytes more than now, as on a
/// machine where memory is used up. What is freed may be had again.
void fail_beyond(std::size_t bytes);

/// Let none fail.
void never_fail();

/// Allocations so far, those that failed among them.
long count_allocations();

/// Those that failed.
long count_refusals();

/// True if the last one that failed was asked for by a shared library, or by what that called. Its
/// file name has `library` in it.
bool was_refused_in(const char* library);

/// Blocks that are not freed.
long count_blocks();

/// The bytes of them.
std::size_t count_bytes();

/// Begin to look for the most bytes.
void watch_peak();

/// The most bytes since then.
std::size_t peak_bytes();

}  // namespace surfmesh::testing
