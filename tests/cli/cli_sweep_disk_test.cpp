// racebeam sweep where the disk is full, or can only be read.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"
#include "tests/support/small_disk.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

class CliSweepDisk : public CliSweepTest {
 protected:
  CliSweepDisk() { fs::create_directory(folder / "out"); }
};

// An empty store is some 110 KB, and 24 reference pictures nearly 200.
TEST_F(CliSweepDisk, FullDiskLosesNothingAndTheSameCommandGoesOnWhenItHasGrown) {
  std::string text = TinySweep;
  text.replace(text.find("sample = 4"), 10, "sample = 24");
  write(text);
  SmallDisk disk(folder / "out", "256k");
  if (!disk.why_not().empty()) GTEST_SKIP() << disk.why_not();
  const auto full = AllOf(HasSubstr("the disk of out is full; "),
                          HasSubstr("make room and run the same command again"));
  EXPECT_THAT(expect(run_words("out"), 2), full);
  EXPECT_THAT(expect({"sweep", "check", "out"}, 0), HasSubstr("sound: "));
  const auto kept = query(store("out"), "SELECT digest FROM frame ORDER BY scene, point, frame");
  EXPECT_THAT(expect(run_words("out"), 2), full) << "still full";
  ASSERT_TRUE(disk.grow("16m"));
  expect_run("out");
  for (const std::string& digest : kept)
    EXPECT_EQ(query(store("out"), "SELECT count(*) FROM frame WHERE digest = " + digest)[0], "1");
  expect_run("whole");
  EXPECT_EQ(frames_of("out"), frames_of("whole"));
  EXPECT_THAT(expect({"sweep", "check", "out"}, 0), HasSubstr("all as they were"));
}

TEST_F(CliSweepDisk, ADiskWithoutAnyRoomIsNamedAndTheSweepBeginsWhenThereIsSome) {
  write(TinySweep);
  SmallDisk disk(folder / "out", "8k");
  if (!disk.why_not().empty()) GTEST_SKIP() << disk.why_not();
  EXPECT_THAT(expect(run_words("out"), 2), HasSubstr("the disk of out is full; "));
  ASSERT_TRUE(disk.grow("16m"));
  expect_run("out");
}

TEST_F(CliSweepDisk, ReadOnlyFolderCanBeReadAndSaysThatItCannotBeWritten) {
  write(TinySweep);
  SmallDisk disk(folder / "out", "4m");
  if (!disk.why_not().empty()) GTEST_SKIP() << disk.why_not();
  expect_run("out");
  const std::string before = frames_of("out");
  ASSERT_TRUE(disk.make_read_only());
  EXPECT_THAT(expect(run_words("out"), 2), HasSubstr("cannot write out: Read-only file system"));
  EXPECT_THAT(expect(run_words("out/new"), 2), HasSubstr("cannot write out/new"));
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0), HasSubstr("8 frames are stored"));
  EXPECT_THAT(expect({"sweep", "check", "out"}, 0), HasSubstr("all as they were"));
  EXPECT_EQ(frames_of("out"), before);
  EXPECT_THAT(expect({"sweep", "export", "out", "--json", "out/x.json"}, 2),
              HasSubstr("cannot write out/x.json"));
}

}  // namespace
}  // namespace racebeam
