// A writer that is killed: what it was told is stored is there, whole.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <random>

#include "tb/base/child.h"
#include "tb/sweep/store_check.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

constexpr int BlockFrames = 5;

std::vector<MeasuredFrame> block(int number) {
  std::vector<MeasuredFrame> frames;
  for (int i = 0; i < BlockFrames; ++i) {
    frames.push_back(measured(number * BlockFrames + i, number * 1000 + i));
    frames.back().histograms["slack"] = {1, number};
  }
  return frames;
}

/// Goes on where the store ends, and tells the number of each block that is stored.
[[noreturn]] void write_blocks(const std::string& file, Journal journal, int told) {
  OpenStore store(file, Access::Write, journal);
  auto number = static_cast<int>(store.frames.read(store.key).size()) / BlockFrames;
  for (;; ++number) {
    store.frames.put(store.key, block(number));
    if (write(told, &number, sizeof number) != sizeof number) _exit(1);
  }
}

void kill_writers(Journal journal, int times) {
  const QuickFolder folder;
  const std::string file = folder / "sweep.sqlite";
  std::mt19937 random(14);
  int stored = 0, rounds_with_blocks = 0;
  for (int round = 0; round < times; ++round) {
    int told[2];
    ASSERT_EQ(pipe(told), 0);
    const pid_t child = fork_child();
    if (child == 0) {
      close(told[0]);
      write_blocks(file, journal, told[1]);
    }
    close(told[1]);
    int number = 0, last = stored - 1;
    // Some are killed while they open the file, some while they write.
    if (round % 4) rounds_with_blocks += read(told[0], &number, sizeof number) > 0;
    if (round % 4) last = number;
    usleep(static_cast<unsigned>(random() % 5'000));
    kill(child, SIGKILL);
    wait_for_child(child);
    while (read(told[0], &number, sizeof number) == sizeof number) last = number;
    close(told[0]);
    if (last < 0) continue;

    ASSERT_THAT(check_store(file).faults, testing::IsEmpty());
    OpenStore store(file, Access::Read);
    const std::vector<FrameRow> rows = store.frames.read(store.key);
    ASSERT_EQ(rows.size() % BlockFrames, 0u) << "all of a block or nothing";
    const auto there = static_cast<int>(rows.size()) / BlockFrames;
    ASSERT_GE(there, last + 1) << "what was committed is there";
    for (int i = stored; i < there; ++i)
      for (const MeasuredFrame& frame : block(i))
        ASSERT_EQ(rows[static_cast<std::size_t>(frame.row.frame)].digest, frame.row.digest);
    const Histogram sum = store.frames.histograms(store.key)["slack"];
    ASSERT_EQ(sum.frames, there * BlockFrames) << "none is counted twice";
    ASSERT_EQ(sum.bins[1], there * (there - 1) / 2 * BlockFrames);
    stored = there;
  }
  EXPECT_GT(rounds_with_blocks, times / 2);
}

TEST(StoreKill, NoCommittedBlockIsLostWhenTheWriterIsKilledNinetyTimes) {
  kill_writers(Journal::Log, 90);
}

TEST(StoreKill, NoCommittedBlockIsLostWithARollbackJournalTenTimes) {
  kill_writers(Journal::Rollback, 10);
}

}  // namespace
}  // namespace racebeam
