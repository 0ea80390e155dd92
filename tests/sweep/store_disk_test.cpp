// A disk that is full, or can only be read.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tb/base/output_file.h"
#include "tb/sweep/store_check.h"
#include "tb/sweep/store_errors.h"
#include "tb/sweep/sweep_folder.h"
#include "tests/support/small_disk.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<MeasuredFrame> block(int number) {
  std::vector<MeasuredFrame> frames;
  for (int i = 0; i < 100; ++i)
    frames.push_back(measured(number * 100 + i, number * 1'000'000 + i));
  return frames;
}

class StoreDisk : public testing::TestWithParam<Journal> {
 protected:
  StoreDisk() { std::filesystem::create_directory(path); }

  QuickFolder folder;
  const std::string path = folder / "disk";
  const std::string file = path + "/sweep.sqlite";
};

TEST_P(StoreDisk, FullDiskKeepsAllBlocksBeforeAndTheSameStoreGoesOnWhenItHasGrown) {
  SmallDisk disk(path);
  if (!disk.why_not().empty()) GTEST_SKIP() << disk.why_not();
  int kept = 0;
  {
    OpenStore store(file, Access::Write, GetParam());
    std::string said;
    for (; kept < 1000 && said.empty(); ++kept) try {
        store.frames.put(store.key, block(kept));
      } catch (const DiskFull& full) {
        said = full.keeping("7 of 9 blocks are kept").what();
        --kept;
      }
    EXPECT_EQ(said, "the disk of " + path +
                        " is full; 7 of 9 blocks are kept; make room and run "
                        "the same command again");
    EXPECT_GT(kept, 3);
    EXPECT_EQ(store.frames.read(store.key).size(), static_cast<std::size_t>(kept) * 100);
    EXPECT_THROW(store.frames.put(store.key, block(kept)), DiskFull) << "still full";
    EXPECT_THAT(check_store(file).faults, IsEmpty());
    ASSERT_TRUE(disk.grow("8m"));
    for (const int last = kept + 10; kept < last; ++kept)
      EXPECT_EQ(store.frames.put(store.key, block(kept)), 100);
  }
  OpenStore store(file, Access::Write, GetParam());
  EXPECT_EQ(store.frames.read(store.key).size(), static_cast<std::size_t>(kept) * 100);
  EXPECT_THAT(check_store(file).faults, IsEmpty());
}

TEST_P(StoreDisk, StoreOfARunThatEndedOnAFullDiskIsWhole) {
  SmallDisk disk(path);
  if (!disk.why_not().empty()) GTEST_SKIP() << disk.why_not();
  int kept = 0;
  try {
    OpenStore store(file, Access::Write, GetParam());
    for (; kept < 1000; ++kept) store.frames.put(store.key, block(kept));
  } catch (const DiskFull&) {
  }
  EXPECT_THAT(check_store(file).faults, IsEmpty());
  ASSERT_TRUE(disk.grow("8m"));
  OpenStore store(file, Access::Write, GetParam());
  EXPECT_EQ(store.frames.put(store.key, block(kept)), 100);
  EXPECT_EQ(store.frames.read(store.key).size(), static_cast<std::size_t>(kept + 1) * 100);
}

TEST_P(StoreDisk, ReadOnlyFolderCanBeReadAndSaysThatItCannotBeWritten) {
  SmallDisk disk(path, "4m");
  if (!disk.why_not().empty()) GTEST_SKIP() << disk.why_not();
  {
    OpenStore store(file, Access::Write, GetParam());
    store.frames.put(store.key, block(0));
  }
  ASSERT_TRUE(disk.make_read_only());
  OpenStore store(file, Access::Read);
  EXPECT_EQ(store.frames.read(store.key).size(), 100u);
  EXPECT_THAT(check_store(file).faults, IsEmpty());
  EXPECT_THROW(OpenStore(file, Access::Write), OutputError);
  EXPECT_NO_THROW(SweepFolder(path, Access::Read));
  EXPECT_EQ(error_of([this] { SweepFolder start(path, Access::Write); }),
            "cannot write " + path + ": Read-only file system");
}

INSTANTIATE_TEST_SUITE_P(Journals, StoreDisk, testing::Values(Journal::Log, Journal::Rollback),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace racebeam
