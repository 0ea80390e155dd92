// racebeam sweep: its figures are those of render, the same command goes on where it stopped, and
// nothing of it is lost.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

TEST_F(CliSweepTest, FiguresAreThoseOfRenderFrameByFrame) {
  write(SmallSweep);
  expect_run("out");
  const auto rows = read_csv(frames_of("out"));
  ASSERT_EQ(rows.size(), 4u * 16);
  std::string list;
  for (const auto& row : rows)
    if (row.at("point") == "p1") list += (list.empty() ? "" : ",") + row.at("frame");
  Program render(folder.path(), {"render", "demo", "--at", list, "--set", "interval_stack_depth=2",
                                 "--set", "hurry_threshold=32", "--stats", "r.json"});
  ASSERT_EQ(render.wait(), 0) << render.err();
  const auto json = read_json(folder / "r.json");
  std::size_t frame = 0;
  for (const auto& row : rows) {
    if (row.at("point") != "p1") continue;
    const auto& one = json.at("frames").at(frame++);
    EXPECT_EQ(row.at("frame"), one.at("frame").dump());
    for (const char* counter : {"decisions", "restarts", "starved_pixels", "give_ups", "emits"})
      EXPECT_EQ(row.at(counter), one.at(counter).dump()) << counter << " of " << row.at("frame");
    EXPECT_EQ(row.at("busy_clocks.max"), one.at("busy_clocks").at("max").dump());
  }
  EXPECT_EQ(frame, 16u);
}

TEST_F(CliSweepTest, TheSameCommandAgainMeasuresNothingAndSaysTheSame) {
  write(SmallSweep);
  Program first(folder.path(), run_words("out"));
  ASSERT_EQ(first.wait(), 0) << first.err();
  const std::string before = frames_of("out");
  Program again(folder.path(), run_words("out"));
  EXPECT_EQ(again.wait(), 0) << again.err();
  EXPECT_EQ(again.out(), first.out());
  EXPECT_EQ(frames_of("out"), before);
}

TEST_F(CliSweepTest, MorePointsMeasureOnlyWhatIsNew) {
  write(SmallSweep);
  expect_run("out");
  std::string more = SmallSweep;
  more.replace(more.find("[2, 4]"), 6, "[2, 4, 6]");
  write(more);
  Program run(folder.path(), run_words("out"));
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.err(), HasSubstr("6 points of 2 knobs; demo, 16 of 11,135 frames (1,664 left "
                                   "out: *ray pattern*); 64 frames are there already"));
  EXPECT_EQ(read_csv(frames_of("out")).size(), 6u * 16);
}

TEST_F(CliSweepTest, ReuseTakesEqualResultsOfAnotherSweep) {
  write(SmallSweep);
  expect_run("out");
  Program other(folder.path(),
                run_words("other", {"--reuse", "out", "--set", "hurry_threshold=32"}));
  EXPECT_EQ(other.wait(), 0) << other.err();
  EXPECT_THAT(other.err(), HasSubstr("32 frames are there already"));
  EXPECT_THAT(other.err(), HasSubstr("32 frames taken over"));
  Program alone(folder.path(), run_words("alone", {"--set", "hurry_threshold=32"}));
  EXPECT_EQ(alone.wait(), 0) << alone.err();
  EXPECT_EQ(other.out(), alone.out());
  EXPECT_EQ(frames_of("other"), frames_of("alone"));
}

TEST_F(CliSweepTest, DryRunSaysThePlanAndWritesNothing) {
  write(SmallSweep);
  Program run(folder.path(), run_words("out", {"--dry-run"}));
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.out(), AllOf(HasSubstr("small: 4 points of 2 knobs; demo, 16 of 11,135 frames"),
                               HasSubstr("on 2 cores"), HasSubstr("nothing was written")));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(CliSweepTest, TermKeepsWhatIsFinishedAndTheSameCommandGoesOn) {
  write(SmallSweep);
  expect_run("whole");
  MarkedProcesses own;
  Program::Setting setting;
  setting.environment = own.mark();
  Program cut(folder.path(), run_words("cut"), setting);
  while (!fs::exists(folder / "cut/status.json")) usleep(1000);  // workers are at work
  cut.signal(SIGTERM);
  EXPECT_EQ(cut.wait(), 130) << cut.err();
  EXPECT_THAT(cut.err(), HasSubstr("frames are kept; the same command goes on"));
  EXPECT_TRUE(own.become(0)) << own.count() << " processes are left";
  expect_run("cut");
  EXPECT_EQ(frames_of("cut"), frames_of("whole"));
}

TEST_F(CliSweepTest, WhoeverIsKilledTheFinishedStoreIsTheSame) {
  write(SmallSweep);
  expect_run("whole");
  MarkedProcesses own;
  Program::Setting setting;
  setting.environment = own.mark();
  int code = -1, kills = 0;
  for (int run = 0; code != 0 && run < 100; ++run) {
    Program one(folder.path(), run_words("killed"), setting);
    for (int n = 0; n < 3 && kills < 12; ++n) {
      while (one.runs() && one.children() == 0) usleep(1000);
      usleep(10'000u * unsigned(kills));
      const std::vector<int> children = one.children_ids();
      if (kills % 3 == 2) one.signal(SIGKILL), ++kills;
      else if (!children.empty()) kill(children.front(), SIGKILL), ++kills;
    }
    code = one.wait();
  }
  EXPECT_EQ(code, 0);
  EXPECT_GE(kills, 1);
  EXPECT_EQ(frames_of("killed"), frames_of("whole"));
  EXPECT_TRUE(own.become(0)) << own.count() << " processes are left";
}

TEST_F(CliSweepTest, AWorkerThatCrashesAtTheSameFrameFailsItsPointAloneWithTheReason) {
  const std::string said = run_with_signals(SIGABRT);
  EXPECT_THAT(said, AllOf(HasSubstr("3 measured, 1 failed"), HasSubstr("a worker died: Aborted")));
  const auto failed = fs::directory_iterator(folder / "out/failed");
  EXPECT_THAT(read_file(failed->path()), HasSubstr("a worker died: Aborted"));
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0), HasSubstr("a worker died: Aborted"));
  EXPECT_THAT(expect(run_words("out"), 1), HasSubstr("1 failed")) << "it is not tried again ...";
  EXPECT_THAT(expect(run_words("out", {"--fresh"}), 0), HasSubstr("0 failed")) << "... until asked";
  expect_run("whole");
  EXPECT_EQ(frames_of("out"), frames_of("whole"));
}

/// Writes to where a worker answers, in between, until it has ended; false if that is not allowed.
bool spoil_answers(int worker) {
  const int process = static_cast<int>(syscall(SYS_pidfd_open, worker, 0));
  if (process < 0) return errno == ESRCH;
  for (; kill(worker, 0) == 0; usleep(200)) {
    const int file = static_cast<int>(syscall(SYS_pidfd_getfd, process, STDOUT_FILENO, 0));
    if (file < 0 && errno == EPERM) return close(process), false;
    if (file < 0) continue;
    const std::string garbage = "nonsense ";
    (void)!send(file, garbage.data(), garbage.size(), MSG_NOSIGNAL);  // of sockets, only
    close(file);
  }
  close(process);
  return true;
}

TEST_F(CliSweepTest, AWorkerThatAnswersWithGarbageFailsItsPointAloneWithWhatItSaid) {
  bool may = true;
  const std::string said = run_with_harm([&may](int worker) {
    if (may) may = spoil_answers(worker);
    if (!may) kill(worker, SIGABRT);
  });
  if (!may) GTEST_SKIP() << "files of other processes may not be had here";
  EXPECT_THAT(said, AllOf(HasSubstr("3 measured, 1 failed"), HasSubstr("answered with garbage")));
  EXPECT_THAT(read_file(fs::directory_iterator(folder / "out/failed")->path()),
              AllOf(HasSubstr("answered with garbage"), HasSubstr("nonsense ")));
  EXPECT_THAT(expect(run_words("out", {"--fresh"}), 0), HasSubstr("0 failed"));
  expect_run("whole");
  EXPECT_EQ(frames_of("out"), frames_of("whole"));
}

TEST_F(CliSweepTest, OfTwoStartsAtOnceOneRunsAndTheOtherSaysSo) {
  write(SmallSweep);
  Program first(folder.path(), run_words("out"));
  while (!fs::exists(folder / "out/sweep.sqlite")) usleep(1000);
  Program second(folder.path(), run_words("out"));
  EXPECT_EQ(second.wait(), 2);
  EXPECT_THAT(second.err(), AllOf(HasSubstr("out is in use by process"),
                                  HasSubstr("racebeam sweep status out shows how far it is")));
  EXPECT_EQ(first.wait(), 0) << first.err();
}

TEST_F(CliSweepTest, CheckMeasuresStoredFramesAgain) {
  write(SmallSweep);
  expect_run("out");
  Program check(folder.path(), {"sweep", "check", "out", "--sample", "10"});
  EXPECT_EQ(check.wait(), 0) << check.err();
  EXPECT_EQ(check.out(),
            "sound: 64 frames, each as its digest says\n"
            "10 stored frames measured again: all as they were\n");
}

TEST_F(CliSweepTest, CheckFindsOneFlippedBit) {
  write(SmallSweep);
  expect_run("out");
  EXPECT_EQ(query(store("out"),
                  "UPDATE frame SET decisions = (decisions | 1) - (decisions & 1) "
                  "WHERE point = 2 AND frame = (SELECT max(frame) FROM frame) RETURNING point")
                .size(),
            1u);
  Program check(folder.path(), {"sweep", "check", "out"});
  EXPECT_EQ(check.wait(), 1) << check.out();
}

TEST_F(CliSweepTest, RacingKeepsTheFrontOfTheFullMeasurement) {
  const std::string goals = "[goals]\npicture_error = \"min\"\nstarved = \"min\"\n";
  std::string text = SmallSweep + goals;
  text.replace(text.find("sample = 16"), 11, "sample = 64");
  text.replace(text.find("[2, 4]"), 6, "[1, 4]");
  write(text);
  Program raced(folder.path(), run_words("raced"));
  ASSERT_EQ(raced.wait(), 0) << raced.err();
  write(text + "[search]\nrace = false\n");
  Program full(folder.path(), run_words("full"));
  ASSERT_EQ(full.wait(), 0) << full.err();
  const auto front = [](const std::string& said) {
    std::set<std::string> names;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string standing, name;
      if (words >> standing >> name && standing == "front") names.insert(name);
    }
    return names;
  };
  EXPECT_FALSE(front(full.out()).empty()) << full.out();
  EXPECT_EQ(front(raced.out()), front(full.out()));
  EXPECT_LT(read_csv(frames_of("raced")).size(), read_csv(frames_of("full")).size());
}

TEST_F(CliSweepTest, PicturesAreThoseOfRender) {
  write(std::string(SmallSweep) + "pictures = [7223, \"worst\"]\n");
  expect_run("out");
  Program render(folder.path(),
                 {"render", "demo", "--at", "7223", "--set", "interval_stack_depth=2", "--set",
                  "hurry_threshold=32", "-o", "r"});
  ASSERT_EQ(render.wait(), 0) << render.err();
  int found = 0, worst = 0;
  for (const auto& row : read_csv(read_file(folder / "out/pictures/index.csv"))) {
    const std::string bytes = read_file(folder / ("out/pictures/" + row.at("file")));
    EXPECT_FALSE(bytes.empty()) << row.at("file");
    worst += row.at("why") == "worst";
    if (row.at("point") != "p1" || !row.at("why").empty()) continue;
    ++found;
    EXPECT_EQ(bytes, read_file(folder / "r/frame_7223.png"));
  }
  EXPECT_EQ(found, 1);
  EXPECT_EQ(worst, 4);
}

TEST_F(CliSweepTest, GuardFramesAreTheWorstOfTheBase) {
  Program scene(folder.path(), {"scene", "new", "room.toml"});
  ASSERT_EQ(scene.wait(), 0) << scene.err();
  write(
      "name = \"g\"\nscenes = [\"room.toml\"]\n[frames]\nsample = 16\nguard = 4\n"
      "[measure]\nsilicon = \"off\"\n[knobs]\nfifo_entries = [8]\n");
  Program run(folder.path(), run_words("out"));
  ASSERT_EQ(run.wait(), 0) << run.err();
  std::map<std::string, int> guards;
  for (const auto& row : read_csv(frames_of("out")))
    guards[row.at("point")] += row.at("kind") == "guard";
  for (const auto& [point, count] : guards)
    EXPECT_THAT(count, testing::AllOf(testing::Ge(1), testing::Le(4))) << point;
  EXPECT_EQ(guards.size(), 2u);
}

TEST_F(CliSweepTest, FaultsOfTheFileAreToldAllAtOnceAndWriteNothing) {
  write("[knobs]\nfifo_entrys = 4\ndr_bits = 99\n");
  Program run(folder.path(), run_words("out"));
  EXPECT_EQ(run.wait(), 2);
  EXPECT_THAT(run.err(), AllOf(HasSubstr("s.toml:2:1: unknown knob 'fifo_entrys'"),
                               HasSubstr("s.toml:3:11"), HasSubstr("2 faults in s.toml")));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(CliSweepTest, OtherFoldersAreLeftAlone) {
  write(SmallSweep);
  fs::create_directory(folder / "mine");
  std::ofstream(folder / "mine/letter.txt") << "dear";
  for (const Words& words :
       {run_words("mine"), Words{"sweep", "status", "mine"}, Words{"sweep", "check", "mine"},
        Words{"sweep", "export", "mine", "--csv", "x.csv"}, Words{"sweep", "status", "nowhere"}}) {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 2) << words[1];
    EXPECT_THAT(run.err(), HasSubstr("is not the folder of a sweep")) << words[1];
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "mine"), {}), 1);
  EXPECT_FALSE(fs::exists(folder / "nowhere"));
}

TEST_F(CliSweepTest, NewWritesASweepThatRuns) {
  Program write_it(folder.path(), {"sweep", "new", "s.toml"});
  ASSERT_EQ(write_it.wait(), 0) << write_it.err();
  Program again(folder.path(), {"sweep", "new", "s.toml"});
  EXPECT_EQ(again.wait(), 2);
  EXPECT_THAT(again.err(), HasSubstr("s.toml exists"));
  Program plan(folder.path(), run_words("out", {"--dry-run"}));
  EXPECT_EQ(plan.wait(), 0) << plan.err();
}

TEST_F(CliSweepTest, StatusSaysHowFarItIsAndWhoWorks) {
  write(SmallSweep);
  Program run(folder.path(), run_words("out"));
  while (!fs::exists(folder / "out/sweep.sqlite")) usleep(1000);
  usleep(200'000);
  Program while_it_runs(folder.path(), {"sweep", "status", "out", "--json"});
  EXPECT_EQ(while_it_runs.wait(), 0) << while_it_runs.err();
  EXPECT_EQ(run.wait(), 0) << run.err();
  Program after(folder.path(), {"sweep", "status", "out", "--json"});
  ASSERT_EQ(after.wait(), 0) << after.err();
  const auto json = after.json();
  EXPECT_EQ(json.at("schema"), "racebeam-sweep-status");
  EXPECT_EQ(json.at("state"), "done");
  EXPECT_EQ(json.at("stored_frames"), 64);
  EXPECT_TRUE(json.at("in_use_by").is_null());
}

}  // namespace
}  // namespace racebeam
