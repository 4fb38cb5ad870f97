// SPDX-License-Identifier: BSD-3-Clause
#include "guest/failing_allocator.hh"

#include <dlfcn.h>
#include <execinfo.h>
#include <malloc.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <limits>

// The names under which glibc has what the functions below take the place of.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace surfmesh::testing {
namespace {

constexpr std::size_t kAnyBytes = std::numeric_limits<std::size_t>::max();

// Constants before any constructor runs: allocations come earlier.
constinit std::atomic<long> allocations = 0;
constinit std::atomic<long> failing = 0;  ///< the number of the one that fails
constinit std::atomic<long> refusals = 0;
constinit std::atomic<long> blocks = 0;
constinit std::atomic<std::size_t> bytes = 0;
constinit std::atomic<std::size_t> most_bytes = kAnyBytes;
constinit std::atomic<std::size_t> peak = 0;

/// Where the last one that failed was asked for.
constexpr int kMostCalls = 100;
constinit std::array<void*, kMostCalls> calls = {};
constinit std::atomic<int> call_count = 0;

/// Apart, so that a debugger can stop there.
[[gnu::noinline]] void* refuse() {
  ++refusals;
  call_count = backtrace(calls.data(), kMostCalls);
  errno = ENOMEM;
  return nullptr;
}

bool is_refused(std::size_t size) {
  const std::size_t limit = most_bytes;
  return ++allocations == failing || (limit != kAnyBytes && bytes + size > limit);
}

void* count(void* block) {
  if (block == nullptr) return nullptr;
  ++blocks;
  const std::size_t now = bytes += malloc_usable_size(block);
  if (now > peak) peak = now;
  return block;
}

void forget(void* block) {
  if (block == nullptr) return;
  --blocks;
  bytes -= malloc_usable_size(block);
}

}  // namespace

void fail_at(long number) {
  never_fail();
  call_count = 0;
  failing = allocations + number;
}

void fail_beyond(std::size_t more) {
  never_fail();
  call_count = 0;
  most_bytes = bytes + more;
}

void never_fail() {
  failing = 0;
  most_bytes = kAnyBytes;
}

void watch_peak() { peak = bytes.load(); }

/// The first call of backtrace() allocates.
[[maybe_unused]] const int first_backtrace = backtrace(calls.data(), kMostCalls);

long count_allocations() { return allocations; }
long count_refusals() { return refusals; }

bool was_refused_in(const char* library) {
  for (int i = 0; i < call_count; ++i) {
    Dl_info info = {};
    if (dladdr(calls[static_cast<std::size_t>(i)], &info) == 0) continue;
    if (std::strstr(info.dli_fname, library) != nullptr) return true;
  }
  return false;
}

long count_blocks() { return blocks; }
std::size_t count_bytes() { return bytes; }
std::size_t peak_bytes() { return peak; }

}  // namespace surfmesh::testing

using namespace surfmesh::testing;  // NOLINT: the functions below belong to no namespace

extern "C" {

void* malloc(std::size_t size) { return is_refused(size) ? refuse() : count(__libc_malloc(size)); }

void* calloc(std::size_t number, std::size_t size) {
  return is_refused(number * size) ? refuse() : count(__libc_calloc(number, size));
}

void* realloc(void* block, std::size_t size) {
  if (block == nullptr) return malloc(size);
  if (is_refused(size)) return refuse();
  forget(block);
  return count(__libc_realloc(block, size));
}

void* memalign(std::size_t alignment, std::size_t size) {
  return is_refused(size) ? refuse() : count(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}

void free(void* block) {
  forget(block);
  __libc_free(block);
}

}  // extern "C"
