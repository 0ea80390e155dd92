// racebeam sweep compare: which points have changed since another sweep or another model, by how
// much, and what cannot be compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tests/cli/sweep_bench.h"
#include "tests/support/fake_yosys.h"
#include "tests/support/json.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// `now` is compared with `before`: the small sweep twice.
class CliSweepCompare : public CliSweepTest {
 protected:
  CliSweepCompare() {
    write(SmallSweep);
    expect_run("before");
    fs::copy(folder / "before", folder / "now", fs::copy_options::recursive);
  }

  static Words words(const Words& more = {}, const std::string& before = "before") {
    Words words = {"sweep", "compare", "now", "--against", before};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Json json(const std::string& before = "before") const {
    Program run(folder.path(), words({"--json"}, before));
    EXPECT_EQ(run.wait(), 0) << run.err();
    return run.json();
  }
  /// Of what is compared with `before`.
  std::vector<std::string> change(const std::string& sql) const { return query(store("now"), sql); }
  /// Of a point in the JSON, by figure.
  static std::map<std::string, Json> figures(const Json& json, const std::string& point) {
    std::map<std::string, Json> all;
    for (const Json& one : json.at("points").elements())
      if (one.at("point") == Json(point))
        for (const Json& figure : one.at("figures").elements())
          all[figure.at("figure").get<std::string>()] = figure;
    return all;
  }

  static double number(const Json& of, const std::string& name) {
    return of.at(name).get<double>();
  }

  static constexpr const char* OfP1 =
      " WHERE point = (SELECT id FROM point WHERE name = 'p1')";  // interval_stack_depth=2
};

TEST_F(CliSweepCompare, WhatHasNotChangedIsTheSameInEveryFrame) {
  EXPECT_THAT(expect(words({"--expect-same"}), 0),
              AllOf(HasSubstr("now against before: the same model, "),
                    HasSubstr("none of 4 points changed: 4 are the same in every frame that both "
                              "have\n"),
                    Not(HasSubstr("only now"))));
  const Json all = json();
  EXPECT_EQ(all.at("schema"), "racebeam-sweep-against");
  EXPECT_EQ(all.at("same"), true);
  for (const Json& point : all.at("points").elements()) {
    EXPECT_EQ(point.at("frames"), 16);
    EXPECT_EQ(point.at("changed"), false);
  }
}

// A figure that changes by the same in every frame; 480 lines have one decision more each.
TEST_F(CliSweepCompare, APointWhoseCounterIsAnotherOneHasChangedByThat) {
  change(std::string("UPDATE frame SET decisions = decisions + 480") + OfP1);
  EXPECT_THAT(
      expect(words(), 0),
      AllOf(HasSubstr("1 of 4 points changed:\n"), HasSubstr("+1 a line (alike in 16 frames)"),
            HasSubstr("interval_stack_depth=2"),
            HasSubstr("3 are the same in every frame that both have\n")));
  expect(words({"--expect-same"}), 1);
  const auto of_p1 = figures(json(), "p1");
  ASSERT_EQ(of_p1.size(), 1u);
  const Json& decisions = of_p1.at("decisions");
  EXPECT_DOUBLE_EQ(number(decisions, "change"), 1);
  EXPECT_NEAR(number(decisions, "now") - number(decisions, "before"), 1, 1e-9);
  EXPECT_EQ(number(decisions, "half_width"), 0);
  EXPECT_EQ(decisions.at("surely"), true);
}

// Mean and interval of interval.h, with Student's t for 15 degrees of freedom.
TEST_F(CliSweepCompare, AChangeHasTheIntervalOfItsPairedFrames) {
  constexpr int Frames = 16, All = 11'135;
  constexpr double Student = 2.131449546;
  change(std::string("UPDATE frame SET seen_starved_pixels = seen_starved_pixels + frame % 97") +
         OfP1);
  double sum = 0, squares = 0, last = 0;
  int count = 0;
  for (const std::string& frame :
       change(std::string("SELECT frame FROM frame") + OfP1 + " ORDER BY frame")) {
    const double more = 100.0 * (std::stoi(frame) % 97) / 307'200;
    sum += more;
    if (count++ > 0) squares += (more - last) * (more - last);
    last = more;
  }
  ASSERT_EQ(count, Frames);
  const double variance = squares / (2.0 * (Frames - 1) * Frames) * (1 - double(Frames) / All);
  const Json starved = figures(json(), "p1").at("starved");
  EXPECT_NEAR(number(starved, "change"), sum / Frames, 1e-9);
  EXPECT_NEAR(number(starved, "half_width"), Student * std::sqrt(variance), 1e-7);
  EXPECT_THAT(expect(words(), 0), HasSubstr(", so far"));
}

TEST_F(CliSweepCompare, APictureMayChangeWithoutAFigure) {
  change(std::string("UPDATE frame SET picture = picture + 1") + OfP1 +
         " AND frame = (SELECT max(frame) FROM frame)");
  EXPECT_THAT(expect(words({"--expect-same"}), 1),
              HasSubstr("p1: no figure, but counters or pixels"));
}

TEST_F(CliSweepCompare, OfTwoFoldersWithOtherFramesThoseThatBothHaveArePaired) {
  change(std::string("DELETE FROM frame") + OfP1 +
         " AND frame IN (SELECT frame FROM frame ORDER BY frame LIMIT 5)");
  const std::size_t left = change(std::string("SELECT frame FROM frame") + OfP1).size();
  ASSERT_LT(left, 16u);
  EXPECT_THAT(expect(words({"--expect-same"}), 0),
              HasSubstr("of 1 point one side has more frames: those that both have are compared, " +
                        std::to_string(left) + " of 16 at least\n"));
  EXPECT_THAT(expect({"sweep", "compare", "before", "--against", "now"}, 0),
              HasSubstr("of 1 point one side has more frames"));
  change("DELETE FROM frame");
  EXPECT_THAT(expect(words(), 2), HasSubstr("have no frame of a point in common"));
}

TEST_F(CliSweepCompare, PointsArePairedByKnobsWhateverTheyAreCalled) {
  std::string text = SmallSweep;
  text.replace(text.find("[2, 4]"), 6, "[8, 4, 2]");
  write(text);
  fs::remove_all(folder / "now");
  expect_run("now");
  EXPECT_THAT(expect(words({"--expect-same"}), 0),
              AllOf(HasSubstr("none of 4 points changed"), HasSubstr("2 points only now: p1, p2")));
  const Json all = json();
  std::map<std::string, std::string> names;
  for (const Json& point : all.at("points").elements())
    names[point.at("point").get<std::string>()] = point.at("point_before").get<std::string>();
  EXPECT_EQ(names.at("p5"), "p1") << "interval_stack_depth=2 hurry_threshold=32";
  EXPECT_EQ(names.at("chip"), "chip");
  EXPECT_THAT(expect({"sweep", "compare", "before", "--against", "now"}, 0),
              HasSubstr("2 points only before: p1, p2"));
}

TEST_F(CliSweepCompare, AKnobThatOnlyOneSideKnowsCountsUnlessItHasAnotherValue) {
  change("UPDATE point SET setting = setting || 'new_knob=1' || char(10)");
  EXPECT_THAT(expect(words(), 2), HasSubstr("have no point in common"));
  fs::remove_all(folder / "now");
  fs::copy(folder / "before", folder / "now", fs::copy_options::recursive);
  query(store("before"),
        "UPDATE point SET setting = replace(setting, 'head_start=0' || char(10), '')");
  EXPECT_THAT(expect(words(), 0), HasSubstr("none of 4 points changed"));
  change(
      "UPDATE point SET setting = replace(setting, 'head_start=0', 'head_start=8') "
      "WHERE name = 'p1'");
  EXPECT_THAT(expect(words(), 0),
              AllOf(HasSubstr("none of 3 points changed"), HasSubstr("1 point only now: p1"),
                    HasSubstr("1 point only before: p1")));
}

TEST_F(CliSweepCompare, AScenesOtherFileIsLeftOut) {
  change("UPDATE scene SET hash = 'another'");
  EXPECT_THAT(expect(words(), 2), AllOf(HasSubstr("have no frame of a point in common"),
                                        HasSubstr("the scene demo is another one than before")));
}

TEST_F(CliSweepCompare, ErrorsAgainstAnotherReferenceAreLeftOut) {
  change("UPDATE point SET setting = replace(setting, 'reference=geometry', 'reference=trace4')");
  change("UPDATE frame SET error_pixels = error_pixels + 1");
  EXPECT_THAT(expect(words({"--expect-same"}), 0),
              HasSubstr("pictures are compared with trace4 now, and were with geometry"));
}

TEST_F(CliSweepCompare, APointThatFailsOnOneSideIsTold) {
  change(
      "INSERT INTO failure SELECT (SELECT id FROM model), (SELECT id FROM scene), id, "
      "'a worker died: Aborted', 2 FROM point WHERE name = 'p1'");
  EXPECT_THAT(expect(words({"--expect-same"}), 1),
              HasSubstr("failed: p1: a worker died: Aborted; it had been measured"));
  EXPECT_THAT(expect({"sweep", "compare", "before", "--against", "now", "--expect-same"}, 1),
              HasSubstr("measured: p1, which had failed: a worker died: Aborted"));
}

TEST_F(CliSweepCompare, TwoModelsInOneFolderAreComparedByNamingItTwice) {
  EXPECT_THAT(expect(words({}, "now"), 2), HasSubstr("now has results of one model only"));
  change("UPDATE model SET hash = '0123456789abcdef0123456789abcdef'");
  change(std::string("UPDATE frame SET restarts = restarts + 960") + OfP1);
  expect_run("now", {"--fresh"});
  const std::string said = expect(words({}, "now"), 0);
  EXPECT_THAT(said,
              AllOf(HasSubstr(" against 01234567 (racebeam "), HasSubstr("1 of 4 points changed")));
  EXPECT_DOUBLE_EQ(number(figures(json("now"), "p1").at("restarts"), "change"), -2);
  EXPECT_THAT(expect(words({"--expect-same"}), 0), HasSubstr("the same model"));
}

TEST_F(CliSweepCompare, WhatIsNoSweepIsRefused) {
  EXPECT_THAT(expect(words({}, "nowhere"), 2), HasSubstr("nowhere is not the folder of a sweep"));
  EXPECT_THAT(expect({"sweep", "compare", "now"}, 2), HasSubstr("--against"));
}

TEST_F(CliSweepTest, ADesignThatHasChangedIsToldWithoutAnInterval) {
  write(
      "[frames]\nsample = 4\nguard = 0\n[measure]\nsilicon = \"generic\"\n"
      "[knobs]\ninterval_stack_depth = [2, 4]\n");
  {
    const FakeYosys fake(FakeYosys::Counts, "echo 'Yosys 0.98'");
    expect_run("before");
  }
  const std::string more =
      "case \"$*\" in *'IntervalStackDepth 2 stacks'*)\n"
      "printf '=== x ===\\n   Number of cells:   9\\n     $_DFF_P_   2\\n' >out\nexit;;\nesac\n";
  const FakeYosys fake(more + FakeYosys::Counts);
  expect_run("now");
  const std::string said =
      expect({"sweep", "compare", "now", "--against", "before", "--expect-same"}, 1);
  EXPECT_THAT(said, AllOf(HasSubstr("1 of 2 points changed"),
                          testing::ContainsRegex("p1 +4 +cells +[0-9]+ +[0-9]+ +\\+4 cells"),
                          Not(HasSubstr("flip_flops"))));
}

}  // namespace
}  // namespace racebeam
