// racebeam sweep when its file or a scene has changed since, when two start at once, and when the
// clock jumps.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class CliSweepChange : public CliSweepTest {
 protected:
  static std::string tiny_of(const std::string& scene) {
    return "scenes = [\"" + scene + "\"]\n" + TinySweep;
  }
};

TEST_F(CliSweepChange, PointsMoreAreRunAndPointsLessAreKeptAndLeftOut) {
  write(TinySweep);
  expect_run("out");
  const std::string before = frames_of("out");
  std::string other = TinySweep;
  other.replace(other.find("[4, 10]"), 7, "[6, 8]");
  write(other);
  Program run(folder.path(), run_words("out"));
  ASSERT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.err(), HasSubstr("the sweep has changed: 2 points more, 1 point less, whose "
                                   "results are kept"));
  EXPECT_THAT(run.out(), Not(HasSubstr("fifo_entries=4")));
  EXPECT_EQ(read_file(folder / "out/sweep.toml"), other);
  write(TinySweep);
  EXPECT_THAT(expect(run_words("out"), 0), HasSubstr("1 point more, 2 points less"));
  for (const auto& row : read_csv(before))
    EXPECT_THAT(frames_of("out"), HasSubstr(row.at("digest")));
}

TEST_F(CliSweepChange, AnotherSceneInTheFileIsMeasuredAndTheOldResultsAreOfTheOther) {
  expect({"scene", "new", "my.toml"}, 0);
  write(tiny_of("my.toml"));
  expect_run("out");
  const std::string first = frames_of("out"), file = read_file(folder / "my.toml");
  std::string changed = file;
  changed.replace(changed.find("height = 384"), 12, "height = 400");
  write(changed, "my.toml");
  const char* const told = "the scene my.toml has changed: 8 older results are of the other one";
  const std::string said = expect(run_words("out"), 0);
  EXPECT_THAT(said, AllOf(HasSubstr(told), Not(HasSubstr("the sweep has changed"))));
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0), HasSubstr(told));
  const std::string both = frames_of("out");
  std::set<std::string> now;
  for (const auto& row : read_csv(both))
    if (row.at("scene") == "my.toml") now.insert(row.at("digest"));
  EXPECT_EQ(now.size(), 8u);
  for (const auto& row : read_csv(first)) EXPECT_EQ(now.count(row.at("digest")), 0u);
  EXPECT_EQ(read_csv(both).size(), 16u);
  EXPECT_THAT(expect({"sweep", "check", "out"}, 0),
              AllOf(HasSubstr("the scene my.toml has changed: its results cannot be repeated"),
                    HasSubstr("8 stored frames measured again: all as they were")));
  fs::remove(folder / "my.toml");
  EXPECT_THAT(expect({"sweep", "check", "out"}, 0), HasSubstr("the scene my.toml cannot be read"));
  write(file, "my.toml");
  EXPECT_THAT(expect(run_words("out"), 0), HasSubstr(told)) << "the other one, now";
  EXPECT_EQ(frames_of("out").find(first.substr(first.find('\n'))), first.find('\n'));
}

TEST_F(CliSweepChange, OfTwoStartsAtOnceOneRunsAndTheOtherSaysSoTwentyTimes) {
  write(TinySweep);
  int refused = 0;
  for (int round = 0; round < 20; ++round) {
    const std::string out = "out" + std::to_string(round);
    Program first(folder.path(), run_words(out)), second(folder.path(), run_words(out));
    const int ids[] = {first.id(), second.id()};
    const int a = first.wait(), b = second.wait();
    ASSERT_TRUE(a == 0 || b == 0) << first.err() << second.err();
    if (a == 0 && b == 0) {  // the second one came when the first had done all
      EXPECT_EQ(first.out(), second.out());
      continue;
    }
    ++refused;
    EXPECT_EQ(std::max(a, b), 2);
    EXPECT_THAT(
        a == 2 ? first.err() : second.err(),
        AllOf(HasSubstr(out + " is in use by process " + std::to_string(ids[a == 2 ? 1 : 0])),
              HasSubstr("racebeam sweep status " + out + " shows how far it is")));
  }
  EXPECT_GE(refused, 1);
}

// Times are recorded; nothing is decided by them.
TEST_F(CliSweepChange, AClockThatJumpsDecidesNothing) {
  write(TinySweep);
  expect_run("whole");
  Program::Setting setting;
  setting.environment = "LD_PRELOAD=" RACEBEAM_JUMPING_CLOCK;
  for (const char* out : {"out", "out"})
    EXPECT_EQ(expect(run_words(out), 0, setting).find("hang"), std::string::npos);
  EXPECT_EQ(frames_of("out"), frames_of("whole"));
  const auto started = query(store("out"), "SELECT started FROM run");
  ASSERT_EQ(started.size(), 1u);
  EXPECT_TRUE(started[0] < "1992" || started[0] > "2032") << started[0];
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0, setting), HasSubstr("done"));
  write(SmallSweep);
  Program first(folder.path(), run_words("new"), setting);
  while (!fs::exists(folder / "new/sweep.sqlite")) usleep(1000);
  EXPECT_THAT(expect(run_words("new"), 2), HasSubstr("new is in use by process"));
  EXPECT_EQ(first.wait(), 0) << first.err();
}

}  // namespace
}  // namespace racebeam
