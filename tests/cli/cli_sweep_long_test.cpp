// Sweeps that are stopped anywhere, that race, that yosys keeps waiting, in another build.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <random>

#include "tests/cli/sweep_bench.h"
#include "tests/support/fake_yosys.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class CliSweepLong : public CliSweepTest {
 protected:
  /// Names of points by the table's first word.
  static std::set<std::string> standing(const std::string& said, const std::string& wanted) {
    std::set<std::string> names;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string word, name;
      if (words >> word >> name && word == wanted) names.insert(name);
    }
    return names;
  }
};

TEST_F(CliSweepLong, StoppedAfterAnyNumberOfBlocksAllRowsAreThoseOfOneRun) {
  std::string text = SmallSweep;
  text.replace(text.find("sample = 16"), 11, "sample = 96");
  write(text);
  expect_run("whole");
  const std::string whole = frames_of("whole");
  constexpr int Frames = 4 * 96, Block = 32;
  std::mt19937 random(14);
  for (int round = 0; round < 20; ++round) {
    const int k = 1 + static_cast<int>(random() % (Frames / Block - 1));
    const std::string out = "out" + std::to_string(round);
    Program run(folder.path(), run_words(out));
    const auto blocks = [&] {
      return fs::exists(store(out)) &&
                     query(store(out), "SELECT 1 FROM sqlite_schema WHERE name = 'frame'").size()
                 ? std::stoi(query(store(out), "SELECT count(*) FROM frame")[0]) / Block
                 : 0;
    };
    while (run.runs() && blocks() < k) usleep(2000);
    run.signal(round % 2 ? SIGTERM : SIGKILL);
    run.wait();
    expect_run(out);
    EXPECT_EQ(frames_of(out), whole) << "stopped after " << k << " blocks";
    fs::remove_all(folder / out);
  }
}

// Surely on the front: nothing dominates it surely, and the full measurement says front.
TEST_F(CliSweepLong, RacingLosesNoPointOfTheFrontOfTheFullMeasurement) {
  const std::string sweeps[] = {
      "[knobs]\ninterval_stack_depth = [1, 2, 3, 4, 6, 8, 64]\nhurry_threshold = [-1, 32, 64]\n",
      "[search]\nmethod = \"sobol\"\npoints = 24\nseed = 3\n[knobs]\ndr_bits = { from = 8, to = 13 "
      "}\n"
      "fifo_entries = [3, 4, 6, 10, 16]\npartial_products_cut = { from = 0, to = 8 }\n",
      "[search]\nmethod = \"one-by-one\"\n[knobs]\ncorner_factor_bits = { from = 6, to = 12 }\n"
      "fifo_short_length_bits = { from = 3, to = 8 }\nskip_shared_edges = [\"on\", \"table\"]\n"
      "hurry_threshold = [-1, 0, 64, 639]\n"};
  for (std::string sweep : sweeps) {
    const bool has_search = sweep.find("[search]") != std::string::npos;
    if (!has_search) sweep = "[search]\n" + sweep;
    const std::string text =
        "[frames]\nsample = 128\nguard = 0\n[goals]\npicture_error = \"min\"\n"
        "busy = \"min\"\n" +
        sweep;
    for (const char* out : {"raced", "full"}) fs::remove_all(folder / out);
    write(text);
    const std::string raced = expect(run_words("raced"), 0);
    write(std::string(text).replace(text.find("[search]\n"), 9, "[search]\nrace = false\n"));
    const std::string full = expect(run_words("full"), 0);
    const auto before = standing(raced, "front");
    const auto front = standing(full, "front");
    EXPECT_FALSE(front.empty()) << full;
    for (const std::string& point : front)
      EXPECT_EQ(before.count(point), 1u) << point << " is lost\n" << raced << full;
    EXPECT_LT(read_csv(frames_of("raced")).size(), read_csv(frames_of("full")).size());
  }
}

// As long as a worker may say nothing, twice.
TEST_F(CliSweepLong, AWorkerThatHangsFailsItsPointAlone) {
  EXPECT_THAT(run_with_signals(SIGSTOP),
              testing::AllOf(HasSubstr("3 measured, 1 failed"),
                             testing::ContainsRegex("frame [0-9]+: a worker said nothing for")));
}

// As long as a synthesis may take.
TEST_F(CliSweepLong, AYosysThatHangsIsEndedAndItsPointsSaySo) {
  write(
      "name = \"s\"\n[frames]\nsample = 4\nguard = 0\n[knobs]\ninterval_stack_depth = [2, 4]\n"
      "[measure]\nsilicon = \"generic\"\n");
  const FakeYosys fake(std::string("case \"$*\" in *'IntervalStackDepth 2 stacks'*)\n") +
                       FakeYosys::Hangs + ";; esac\n" + FakeYosys::Counts);
  EXPECT_THAT(expect(run_words("out"), 0),
              HasSubstr("no silicon of p1: stacks with IntervalStackDepth=2: yosys did not end "
                        "within 300 seconds"));
  EXPECT_TRUE(fake.is_gone());
  EXPECT_EQ(read_csv(frames_of("out")).size(), 8u);
}

}  // namespace
}  // namespace racebeam
