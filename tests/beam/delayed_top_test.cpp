// Promises of `--delays`: racebeam_top with the registers built in, in RTL, has the pins that the
// chip with a delay_plan has, in every clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "sc/beam/engine.h"
#include "sc/beam/knobs.h"
#include "sc/swap/channel_delays.h"
#include "tb/base/project_folder.h"
#include "tb/bench/wired_bench.h"
#include "tb/twin/delays.h"
#include "tb/verilate/rtl_plugin.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr int DemoFrames = 12799;
constexpr std::uint64_t FrameClocks = 525 * 1600;

struct Variant {
  const char* name;
  int interval_latency, interval_capacity;  // 0: without
  int line_latency;
};
constexpr Variant Short{"interval_1", 1, 1, 0};
constexpr Variant Both{"interval_3_line_5", 3, 4, 5};
constexpr Variant Long{"interval_8", 8, 8, 0};
void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }

std::string with(std::string text, const std::string& what, const std::string& instead) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), instead);
}

/// racebeam_top with other modules in the place of two units; nothing else is another.
std::string built_in_rtl(const Variant& variant, const std::string& folder) {
  std::ifstream own(rtl_file("racebeam_top"));
  std::ostringstream read;
  read << own.rdbuf();
  std::string text = read.str();
  const std::string place = RACEBEAM_SOURCE_DIR "/tests/beam/";
  RtlSources sources{"racebeam_top", {folder + "/racebeam_top.sv"}};
  if (variant.interval_latency) {
    text = with(text, "interval_fifo #(\n",
                fmt::format("delayed_interval_fifo #(\n.Latency({}), .Capacity({}),\n",
                            variant.interval_latency, variant.interval_capacity));
    sources.files.push_back(place + "delayed_interval_fifo.sv");
  }
  if (variant.line_latency) {
    text = with(text, "camera_unit #(\n",
                fmt::format("delayed_camera_unit #(\n.Latency({0}), .Capacity({0}),\n",
                            variant.line_latency));
    sources.files.push_back(place + "delayed_camera_unit.sv");
  }
  std::ofstream(sources.files[0]) << text;
  sources.signals = true;  // to be put to a frame
  return rtl_plugin(sources);
}

std::shared_ptr<const delay_plan> plan_of(const Variant& variant) {
  delay_plan plan;
  if (variant.interval_latency) {
    plan.channels.push_back(delayed_channel(beam_engine(), "interval", variant.interval_latency));
    plan.channels.back().capacity = variant.interval_capacity;
  }
  if (variant.line_latency)
    plan.channels.push_back(delayed_channel(beam_engine(), "line", variant.line_latency));
  return std::make_shared<delay_plan>(plan);
}

class DelayedTop : public testing::TestWithParam<Variant> {
 protected:
  /// Clocks in which pins differ, over frames of the demo.
  std::uint64_t differences(const std::shared_ptr<const delay_plan>& plan,
                            const std::vector<int>& frames) {
    unit_choices units;
    units.by_unit["racebeam_top"] = {unit_choice::Model, true,
                                     built_in_rtl(GetParam(), folder.path())};
    const planned_delays delays(plan);
    WiredBench bench({beam_engine(), knob_values(knobs()), nullptr, DemoFrames, units});
    for (const int frame : frames) {
      bench.seek(frame);
      bench.render();
    }
    const Lockstep& top = *bench.locksteps().at(0);
    EXPECT_EQ(top.clocks() / FrameClocks, frames.size());
    if (plan && top.first())
      ADD_FAILURE() << top.differences() << " differ, the first in clock "
                    << top.first()->first_clock();
    return top.differences();
  }
  ScratchFolder folder;
};

// In 7223 the beam starves.
TEST_P(DelayedTop, PinsAreThoseForetoldInEveryClock) {
  EXPECT_EQ(differences(plan_of(GetParam()), {0, 1, 5000, 7223}), 0u);
}

// The comparison would see it.
TEST_P(DelayedTop, PinsAreNotThoseOfTheChipWithoutDelays) {
  EXPECT_GT(differences(nullptr, {7223}), 0u);
}

INSTANTIATE_TEST_SUITE_P(Variants, DelayedTop, testing::Values(Short, Both, Long),
                         testing::PrintToStringParamName());

using LongDelayedTop = DelayedTop;
TEST_P(LongDelayedTop, PinsAreThoseForetoldInTwentyThreeFrames) {
  std::vector<int> frames;
  for (int n = 0; n < 23; ++n) frames.push_back(n * DemoFrames / 23);
  EXPECT_EQ(differences(plan_of(GetParam()), frames), 0u);
}
INSTANTIATE_TEST_SUITE_P(LongVariants, LongDelayedTop, testing::Values(Short, Both, Long),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace racebeam
