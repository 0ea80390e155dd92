// Promises of tb/trace/condition.h, on the chip of the demo.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/condition.h"

#include <gmock/gmock.h>

#include "sc/beam/chip_core.h"
#include "tb/base/errors.h"
#include "tb/bench/signal_bench.h"
#include "tb/trace/chip_signals.h"
#include "tb/trace/trace_run.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class ConditionTest : public testing::Test {
 protected:
  ConditionTest() { run.go_to(TracePoint{7223, -100, 333}.ordinal(raster)); }
  /// Whether it holds in the clock that the run stands in.
  bool holds(const std::string& text) {
    return Condition(text, chip_signals(bench), raster).holds(run.clock());
  }
  std::string refusal(const std::string& text) {
    try {
      Condition(text, chip_signals(bench), raster);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }

  const TraceAxis raster;
  SignalBench bench{{knobs{}}};
  TraceRun run{bench, raster, 7223};
};

TEST_F(ConditionTest, PlacesOfTheBeamAreSigned) {
  EXPECT_TRUE(holds("frame == 7223 && line == -100 && clock == 333"));
  EXPECT_TRUE(holds("beam.line < 0 && beam.pixel == 6"));
  EXPECT_FALSE(holds("line == 924"));
}

TEST_F(ConditionTest, OperatorsAreThoseOfC) {
  for (const char* text :
       {"line + 100 == 0", "!(line > 0)", "!line == 0", "line * 2 <= -200", "line != 3",
        "(line < 0 ? 5 : 6) == 5", "frame / 2 > 3611", "line > 0 || frame >= 7223",
        "frame == 0x1c37", "bit(frame, 0) == 1", "bit(frame, 3) == 0", "frame - 7222"})
    EXPECT_TRUE(holds(text)) << text;
  for (const char* text : {"line == 0 && frame", "!frame", "frame == 0x1c38", "line - line"})
    EXPECT_FALSE(holds(text)) << text;
}

TEST_F(ConditionTest, EverySignalIsNamedWithAndWithoutTheChip) {
  int checked = 0;
  for (const ChipSignal& signal : chip_signals(bench)) {
    if (signal.bits > 31) continue;
    const auto raw = static_cast<long long>(signal.read());
    const std::string low = std::to_string(raw),
                      wrapped = std::to_string(raw - (1LL << signal.bits)),
                      short_name = signal.path().substr(5);
    for (const std::string& name : {signal.path(), short_name})
      EXPECT_TRUE(holds(name + " == " + low + " || " + name + " == " + wrapped)) << name;
    ++checked;
  }
  EXPECT_GT(checked, 400);
}

TEST_F(ConditionTest, ANameThatOneSignalHasNeedsNoPath) {
  EXPECT_EQ(holds("sd_q > 1"), holds("u_subdivider.sd_q > 1"));
  EXPECT_NE(holds("sd_q > 1"), holds("sd_q <= 1"));
  testing::internal::CaptureStderr();
  EXPECT_EQ(holds("u_stacks.sd_q > 1"), holds("u_subdivider.sd_q > 1"));
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("u_stacks.sd_q is chip.u_subdivider.sd_q"));
}

TEST_F(ConditionTest, SignedSignalsAreSigned) {
  chip_core chip;
  const knobs k;
  chip.clock(false, k);
  chip.deposit(7223, k);
  for (auto at = TracePoint{7223, FirstLine, 0}.ordinal(raster); at < run.clock(); ++at)
    chip.clock(true, k);
  bool negative = false;
  for (const probe& one : registers_of(chip.ray_stepper, k)) {
    if (one.name.find(".dr2_q") == std::string::npos) continue;
    const int value = wrap_signed(static_cast<int>(one.read()), one.bits);
    negative = negative || value < 0;
    EXPECT_TRUE(holds("u_ray_stepper." + one.name + " == " + std::to_string(value))) << one.name;
  }
  EXPECT_TRUE(negative) << "or this shows nothing";
}

TEST_F(ConditionTest, StatesAreWords) {
  int told = 0;
  for (const char* word : {"left", "right", "bisect", "return"})
    told += holds(std::string("u_subdivider.state_q == ") + word);
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(holds("u_camera_unit.phase_q == run")) << "a state, though there is a wire chip.run";
  EXPECT_FALSE(holds("u_camera_unit.phase_q != run"));
  EXPECT_TRUE(holds("u_camera_unit.phase_q == 3 && run == 1"));
}

TEST_F(ConditionTest, RefusesWhatItCannotAsk) {
  EXPECT_THAT(refusal("u_stacks.dr1_q == 4"),
              HasSubstr("there is no signal 'u_stacks.dr1_q'; did you mean 'chip.u_ray_stepper"))
      << "there are three";
  EXPECT_THAT(refusal("u_subdivider.i1_w == 4"), HasSubstr("did you mean 'u_subdivider.i1_q'?"));
  EXPECT_THAT(refusal("line = 240"), HasSubstr("'=' at character 6; to compare write '=='"));
  EXPECT_THAT(refusal("line == "), HasSubstr("--when 'line == '"));
  EXPECT_THAT(refusal("(line"), HasSubstr("--when '(line'"));
  EXPECT_THAT(refusal("3 < 4"), HasSubstr("names no signal"));
  EXPECT_THAT(refusal("u_navigator.nav_state_q == load"),
              HasSubstr("u_navigator.nav_state_q has no state 'load' (there is: idle, to_plus"));
  EXPECT_THAT(refusal("bisect == 2"), HasSubstr("there is no signal 'bisect'"));
  EXPECT_THAT(refusal("line == 0, clock == 3"), HasSubstr("join them with && or ||"));
  EXPECT_THAT(refusal("line & 1"), HasSubstr("'&' at character 6; bits are read by bit(x, n)"));
  EXPECT_THAT(refusal("line ^ 1"), HasSubstr("bits are read by bit(x, n)"));
  EXPECT_THAT(refusal("'line == 1'"), HasSubstr("leave out the inner quotes"));
  EXPECT_THAT(refusal("sin(line)"), HasSubstr("no signal 'sin'"));
  EXPECT_EQ(refusal("line >= 240 && line <= 241"), "");
}

}  // namespace
}  // namespace racebeam
