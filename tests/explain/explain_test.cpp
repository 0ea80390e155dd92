// The story of a line against the chip a line at a time, its counters and its intervals.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "sc/beam/subdivider_core.h"
#include "sc/beam/tlm/chip_lines.h"
#include "tb/bench/interval_log.h"
#include "tb/explain/explain_json.h"
#include "tb/explain/explain_text.h"
#include "tb/explain/line_watcher.h"
#include "tb/explain/step_text.h"
#include "tb/scene/scene_reader.h"
#include "tests/support/json.h"

namespace racebeam {
namespace {

/// The visible lines of a frame: their stories, and what another chip says of them.
struct ToldFrame {
  struct Line {
    LineStory story;
    std::array<std::uint8_t, VisibleColumns> pixels;
    frame_stats stats;
    std::vector<IntervalEvent> events;
  };
  std::vector<Line> lines;

  ToldFrame(int frame, const knobs& k, const scene_program* program = nullptr) {
    IntervalLog log;
    chip_lines told({k, program, false, false, nullptr}), other({k, program, false, false, &log});
    told.deposit(frame);
    other.deposit(frame);
    std::vector<int> columns;
    for (int column = 0; column < VisibleColumns; ++column)
      columns.push_back(other.column_clock(column));
    LineWatcher watcher(told.registers(), k);
    for (int y = FirstLine; y < FirstVisibleLine + VisibleRows; ++y) {
      other.run_line();
      frame_stats stats = other.take_stats();
      std::vector<IntervalEvent> events = log.take();
      if (other.visible())
        lines.push_back({watcher.watch(columns), other.pixels(), std::move(stats), events});
      else told.run_line();
    }
  }
};

// Without a starved pixel, on both shadings, with ray pattern in part and all over, too much for
// the chip, and with an inverted palette.
class LineStoryOfFrame : public testing::TestWithParam<int> {
 protected:
  const ToldFrame frame{GetParam(), {}};
};

INSTANTIATE_TEST_SUITE_P(Frames, LineStoryOfFrame,
                         testing::Values(1000, 2600, 3900, 5000, 7223, 8400, 8980));

TEST_P(LineStoryOfFrame, ColoursAreThoseOfTheChipAndTheIndexExplainsThem) {
  ASSERT_EQ(frame.lines.size(), static_cast<std::size_t>(VisibleRows));
  for (const ToldFrame::Line& line : frame.lines)
    for (int column = 0; column < VisibleColumns; ++column) {
      const ShownColumn& shown = line.story.columns[column];
      ASSERT_EQ(shown.colour, line.pixels[column]) << line.story.y << ' ' << column;
      ASSERT_EQ(shown.colours[shown.index], shown.colour) << line.story.y << ' ' << column;
    }
}

TEST_P(LineStoryOfFrame, StepsAddUpToTheCountersOfTheLine) {
  for (const ToldFrame::Line& line : frame.lines) {
    StepTotals sums;
    std::uint64_t emits = 0, give_ups = 0;
    for (const TracedInterval& interval : line.story.intervals) {
      const StepTotals t = totals(line.story, interval);
      sums.left += t.left;
      sums.right += t.right;
      sums.bisect += t.bisect;
      sums.walks += t.walks;
      sums.returns += t.returns;
      sums.waits += t.waits;
      sums.pushes += t.pushes;
      sums.restarts += t.restarts;
      emits += interval.known();
      give_ups += interval.end == IntervalEnd::GivenUp;
    }
    const frame_counters& of_chip = line.stats.counters();
    const auto of = [](int sum) { return static_cast<std::uint64_t>(sum); };
    ASSERT_EQ(of(sums.left), of_chip.left_decisions) << line.story.y;
    ASSERT_EQ(of(sums.right), of_chip.right_decisions) << line.story.y;
    ASSERT_EQ(of(sums.bisect), of_chip.bisection_steps) << line.story.y;
    ASSERT_EQ(of(sums.decisions()), of_chip.decisions()) << line.story.y;
    ASSERT_EQ(of(sums.walks), of_chip.adjust_steps) << line.story.y;
    ASSERT_EQ(of(sums.returns + sums.waits), of_chip.return_clocks) << line.story.y;
    ASSERT_EQ(of(sums.waits), of_chip.fifo_full_stalls) << line.story.y;
    ASSERT_EQ(of(sums.pushes), of_chip.pushes) << line.story.y;
    ASSERT_EQ(of(sums.restarts), of_chip.restarts) << line.story.y;
    ASSERT_EQ(emits, of_chip.emits) << line.story.y;
    ASSERT_EQ(give_ups, of_chip.give_ups) << line.story.y;
  }
}

TEST_P(LineStoryOfFrame, EachClockOfTheTracerBelongsToOneInterval) {
  for (const ToldFrame::Line& line : frame.lines) {
    const LineStory& story = line.story;
    ASSERT_GE(story.tracer_begin, 0);
    int clock = story.tracer_begin, pixel = 0;
    for (const TracerStep& step : story.steps) {
      ASSERT_EQ(step.clock, clock) << story.y;
      clock += step.clocks;
    }
    std::size_t step = 0;
    for (const TracedInterval& interval : story.intervals) {
      ASSERT_EQ(interval.first, pixel) << story.y;
      ASSERT_EQ(interval.step_begin, step) << story.y;
      pixel = interval.last + 1;
      step = interval.step_end;
      if (!interval.known()) continue;
      ASSERT_TRUE(story.steps[step - 1].emits) << story.y;
      ASSERT_EQ(story.steps[step - 1].clock, interval.clock) << story.y;
    }
    ASSERT_EQ(pixel, VisibleColumns) << story.y;
    ASSERT_EQ(step, story.steps.size()) << story.y;
  }
}

TEST_P(LineStoryOfFrame, IntervalsAreThoseThatTheChipTellsAnObserver) {
  for (const ToldFrame::Line& line : frame.lines) {
    ASSERT_EQ(line.story.intervals.size(), line.events.size()) << line.story.y;
    for (std::size_t i = 0; i < line.events.size(); ++i) {
      const TracedInterval& interval = line.story.intervals[i];
      const IntervalEvent& event = line.events[i];
      ASSERT_EQ(interval.first, event.from);
      ASSERT_EQ(interval.last, event.to);
      ASSERT_EQ(interval.clock, event.clock);
      ASSERT_EQ(totals(line.story, interval).decisions(), event.decisions);
      if (!event.known()) continue;
      ASSERT_EQ(interval.end != IntervalEnd::GivenUp, event.wall);
      ASSERT_EQ(interval.axis, event.wall ? event.face : -1);
    }
  }
}

TEST_P(LineStoryOfFrame, LateAndUnknownPixelsAreTheStarvedOnes) {
  const Show demo;
  std::set<PixelFate> fates;
  for (std::size_t row = 0; row < frame.lines.size(); row += 7)
    for (int column = 0; column < VisibleColumns; column += 7) {
      const LineStory& story = frame.lines[row].story;
      const Explanation e(demo, story, column);
      fates.insert(e.fate);
      if (e.fate == PixelFate::Pattern) continue;
      ASSERT_EQ(e.fate == PixelFate::Late || e.fate == PixelFate::Never, e.shown().starving)
          << story.y << ' ' << column;
      ASSERT_EQ(e.why_unknown().empty(), e.fate == PixelFate::InTime);
      const int value = e.fate == PixelFate::InTime ? e.interval->value
                        : e.before                  ? e.before->value
                                                    : 0;
      ASSERT_EQ(e.shown().display, value) << story.y << ' ' << column;
    }
  EXPECT_EQ(fates.count(PixelFate::Pattern) > 0, GetParam() == 2600 || GetParam() == 3900);
  EXPECT_EQ(fates.count(PixelFate::InTime) > 0, GetParam() != 2600);
  EXPECT_TRUE(GetParam() != 7223 || fates.count(PixelFate::Late) > 0);
}

TEST_P(LineStoryOfFrame, EachIntervalEndsInTheRoomThatItsWayLeadsTo) {
  for (const ToldFrame::Line& line : frame.lines)
    for (const TracedInterval& interval : line.story.intervals) {
      if (!interval.known()) continue;
      ASSERT_FALSE(interval.way.empty());
      const int depth = static_cast<int>(interval.way.size()) - 1;
      ASSERT_LE(depth, knobs().room_depth_limit());
      ASSERT_EQ(interval.behind != SolidRoom && interval.end != IntervalEnd::GivenUp,
                interval.end == IntervalEnd::Missed);
      ASSERT_TRUE(interval.end != IntervalEnd::Missed || interval.depth == depth + 1);
      ASSERT_TRUE(interval.end != IntervalEnd::Solid || interval.depth == depth);
      ASSERT_EQ(interval.axis < 0, interval.end == IntervalEnd::GivenUp);
    }
}

TEST(LineStoryOfScene, IsToldForASceneFileWithSeveralPortalsInAFace) {
  SceneResult result = read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/aqueduct.toml");
  ASSERT_TRUE(result.faults.none());
  const Show show(std::move(result.scene), "");
  const knobs k = show.standard_knobs();
  ASSERT_GT(k.portals_per_face, 1);
  const ToldFrame frame(500, k, show.program());
  for (const ToldFrame::Line& line : frame.lines) {
    std::uint64_t decisions = 0;
    for (const TracedInterval& interval : line.story.intervals)
      decisions += totals(line.story, interval).decisions();
    ASSERT_EQ(decisions, line.stats.decisions()) << line.story.y;
    for (int column = 0; column < VisibleColumns; ++column)
      ASSERT_EQ(line.story.columns[column].colour, line.pixels[column]);
  }
}

TEST(Explanation, SaysInTextWhatTheJsonSays) {
  const Show demo;
  const Explanation e(demo, {}, 1000, 320, 240);
  const auto json = Json::parse(explain_json(e, {}, "demo"));
  const std::string text = explain_text(e, "demo");
  ASSERT_EQ(json.at("fate"), "in_time");
  for (const char* name : {"first", "last", "length"})
    EXPECT_NE(text.find(json.at("interval").at(name).dump()), std::string::npos) << name;
  for (const auto& room : json.at("interval").at("hit").at("way").elements())
    EXPECT_NE(text.find("room " + room.at("id").dump()), std::string::npos);
  EXPECT_NE(text.find(json.at("trace").get<std::string>()), std::string::npos);
  for (const auto& step : json.at("interval").at("steps").elements())
    EXPECT_NE(text.find("\n" + std::string(5 - step.at("clock").dump().size(), ' ') +
                        step.at("clock").dump() + " "),
              std::string::npos);
}

// Lines that begin a story, each with its end: contract 9.9 tells the first intervals of this one.
TEST(Explanation, TellsTheContractsExample) {
  const LineStory story = line_story(2, -240, {}, nullptr);
  EXPECT_EQ(story.tracer_begin, 50);
  ASSERT_GE(story.intervals.size(), 2U);
  const TracedInterval& first = story.intervals[0];
  EXPECT_EQ(first.first, 0);
  EXPECT_EQ(first.last, 0);
  EXPECT_EQ(first.clock, 135);
  EXPECT_EQ(first.end, IntervalEnd::Solid);
  EXPECT_EQ(first.depth, 3);
  EXPECT_EQ(first.way.size(), 4U);
  const auto step_at = [&](int clock) -> const TracerStep& {
    for (const TracerStep& step : story.steps)
      if (step.clock <= clock && clock < step.clock + step.clocks) return step;
    throw std::out_of_range("clock");
  };
  EXPECT_TRUE(step_at(50).walks);
  EXPECT_EQ(answer_text(step_at(53)), "--+");
  EXPECT_FALSE(step_at(54).agrees);
  EXPECT_EQ(step_at(54).state, StateRight);
  EXPECT_EQ(outcomes(step_at(63)), (std::vector<std::string>{"push", "descend"}));
  EXPECT_EQ(question_text(step_at(73)), "x or y first");
  EXPECT_EQ(outcomes(step_at(84)), (std::vector<std::string>{"enter"}));
  EXPECT_EQ(outcomes(step_at(135)), (std::vector<std::string>{"emit", "climb"}));
  EXPECT_EQ(outcomes(step_at(137)), (std::vector<std::string>{"pop"}));
  EXPECT_EQ(outcomes(step_at(213)), (std::vector<std::string>{"restart"}));
}

}  // namespace
}  // namespace racebeam
