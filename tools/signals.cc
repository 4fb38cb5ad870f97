// SPDX-License-Identifier: BSD-3-Clause
#include "signals.hh"

#include <dirent.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <ctime>
#include <string_view>
#include <utility>

#include "exit_status.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// What a run has to end by itself, which mostly takes some milliseconds.
constexpr long kGraceNanoseconds = 250'000'000;

/// More than any command writes at once.
constexpr std::size_t kMostTemporaries = 16;

constexpr int kNotDone = -1;

// A handler may use lock-free atomics, and few functions: see signal-safety(7).
std::atomic<int> signal_number = 0;
std::atomic<bool> is_committing = false;
std::atomic<int> status_when_done = kNotDone;
std::array<std::atomic<const char*>, kMostTemporaries> temporaries = {};
std::atomic<timer_t> timer = {};
std::atomic<const char*> terminal_wipe = nullptr;
std::atomic<bool> is_silent = false;
std::atomic<const char*> crash_text = nullptr;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
              std::atomic<const char*>::is_always_lock_free &&
              std::atomic<timer_t>::is_always_lock_free);

void start_timer() {
  itimerspec time = {};
  time.it_value.tv_nsec = kGraceNanoseconds;
  timer_settime(timer, 0, &time, nullptr);
}

/// Remove the files in a folder, and the folder. Calls of opendir would not be safe here.
void remove_folder(const char* path) {
  const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  alignas(dirent64) std::array<char, 4096> entries;
  ssize_t size = 0;
  while ((size = getdents64(folder, entries.data(), entries.size())) > 0) {
    for (ssize_t at = 0; at < size;) {
      const auto* entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      unlinkat(folder, entry->d_name, 0);
      at += entry->d_reclen;
    }
  }
  close(folder);
  rmdir(path);
}

void remove_at_once(const char* path) {
  if (unlink(path) != 0 && (errno == EISDIR || errno == EPERM)) remove_folder(path);
}

void remove_temporaries() {
  for (const auto& temporary : temporaries) {
    if (const char* path = temporary) remove_at_once(path);
  }
}

void end_at_once() {
  if (is_committing) return start_timer();
  wipe_terminal();
  if (status_when_done != kNotDone) _exit(status_when_done);
  remove_temporaries();
  constexpr std::string_view kText = "surfmesh: stopped by a signal\n";
  if (!is_silent) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, kText.data(), kText.size());
  }
  _exit(kKilledBySignal + signal_number);
}

extern "C" void stop(int number) {
  const int code = errno;
  int none = 0;
  if (signal_number.compare_exchange_strong(none, number) && status_when_done == kNotDone) {
    start_timer();
  } else {
    end_at_once();
  }
  errno = code;
}

extern "C" void stop_late(int /*number*/) {
  const int code = errno;
  end_at_once();
  errno = code;
}

extern "C" void tell_crash(int /*number*/) {
  wipe_terminal();
  remove_temporaries();
  const char* text = crash_text;
  if (text && !is_silent) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
  }
  _exit(kFailed);
}

/// What a program is sent for its own faults.
constexpr std::array kCrashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// With a stack of its own, a handler runs even where recursion has used up the program's.
void use_own_stack() {
  alignas(std::max_align_t) static std::array<char, 65536> room;
  stack_t stack = {};
  stack.ss_sp = room.data();
  stack.ss_size = room.size();
  sigaltstack(&stack, nullptr);
}

bool is_ignored(int number) {
  struct sigaction action = {};
  return sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void handle(int number, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(number, &action, nullptr);
}

}  // namespace

void catch_signals() {
  sigevent event = {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  timer_t made = {};
  if (timer_create(CLOCK_MONOTONIC, &event, &made) == 0) timer = made;
  handle(SIGALRM, stop_late, SA_RESTART);
  // Without SA_RESTART, so that a blocked open or read of a pipe is interrupted.
  handle(SIGINT, stop, 0);
  handle(SIGTERM, stop, 0);
  // nohup has it ignored, and that is to stay.
  if (!is_ignored(SIGHUP)) handle(SIGHUP, stop, 0);
}

void take_errors_for_signals() {
  handle(SIGXFSZ, SIG_IGN, 0);
  handle(SIGPIPE, SIG_IGN, 0);
}

int caught_signal() { return signal_number; }

void throw_if_signalled() {
  if (caught_signal() != 0) throw Error(ErrorCode::Cancelled, "stopped by a signal");
}

void commit_against_signals(int status, const std::function<void()>& commit) {
  is_committing = true;
  try {
    throw_if_signalled();
    commit();
  } catch (...) {
    is_committing = false;
    throw;
  }
  status_when_done = status;
  is_committing = false;
}

void be_silent_on_signals() { is_silent = true; }

TellsCrash::TellsCrash(std::string text) : text_(std::move(text)) {
  crash_text = text_.c_str();
  use_own_stack();
  for (const int number : kCrashes) handle(number, tell_crash, SA_ONSTACK);
}

TellsCrash::~TellsCrash() {
  for (const int number : kCrashes) handle(number, SIG_DFL, 0);
  crash_text = nullptr;
}

void set_terminal_wipe(const char* text) { terminal_wipe = text; }

void wipe_terminal() {
  const char* text = terminal_wipe.exchange(nullptr);
  if (!text) return;
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
}

RemovedOnSignal::RemovedOnSignal(const std::filesystem::path& path) : path_(path.string()) {
  if (path_.empty()) return;
  for (auto& temporary : temporaries) {
    const char* none = nullptr;
    if (temporary.compare_exchange_strong(none, path_.c_str())) return;
  }
}

RemovedOnSignal::~RemovedOnSignal() {
  for (auto& temporary : temporaries) {
    const char* own = path_.c_str();
    if (temporary.compare_exchange_strong(own, nullptr)) return;
  }
}

}  // namespace surfmesh
