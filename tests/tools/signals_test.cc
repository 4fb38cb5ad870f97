// SPDX-License-Identifier: BSD-3-Clause
#include "signals.hh"

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <limits>

#include "support/folders.hh"

namespace surfmesh {
namespace {

constexpr const char* kCrashText = "surfmesh: error: it crashed\n";

/// Recurse until the stack is used up: long before the end.
std::size_t descend(std::size_t depth) {
  if (depth == std::numeric_limits<std::size_t>::max()) return 0;
  volatile char room[4096] = {};
  room[depth % sizeof(room)] = 1;
  const std::size_t below = descend(depth + 1);
  return below + static_cast<std::size_t>(room[0]);
}

TEST(TellsCrash, EndsTheProgramWithATextAndStatusOne) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    EXPECT_EXIT(
        {
          const TellsCrash tells(kCrashText);
          std::raise(signal);
        },
        testing::ExitedWithCode(1), kCrashText)
        << signal;
  }
}

TEST(TellsCrash, TellsAStackThatIsUsedUp) {
  EXPECT_EXIT(
      {
        const TellsCrash tells(kCrashText);
        descend(0);
      },
      testing::ExitedWithCode(1), kCrashText);
}

TEST(TellsCrash, RemovesTemporaryFiles) {
  const TestFolder folder;
  const std::filesystem::path path = folder / "half_written.off";
  write_text(path, "OFF");
  EXPECT_EXIT(
      {
        const RemovedOnSignal removed(path);
        const TellsCrash tells(kCrashText);
        std::raise(SIGSEGV);
      },
      testing::ExitedWithCode(1), kCrashText);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TellsCrash, IsSilentWhereAnotherProcessTells) {
  EXPECT_EXIT(
      {
        be_silent_on_signals();
        const TellsCrash tells(kCrashText);
        std::raise(SIGSEGV);
      },
      testing::ExitedWithCode(1), "^$");
}

TEST(TellsCrash, LeavesLaterCrashesAlone) {
  EXPECT_EXIT(
      {
        { const TellsCrash tells(kCrashText); }
        std::raise(SIGABRT);
      },
      testing::KilledBySignal(SIGABRT), "^$");
}

}  // namespace
}  // namespace surfmesh
