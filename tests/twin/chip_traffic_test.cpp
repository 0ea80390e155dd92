// The traffic of units in the wired chip, captured in the middle of the demo: RTL and model that
// get it say what was captured, and the cores make the same traffic.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/chip_traffic.h"

#include <gtest/gtest.h>

#include "sc/beam/engine.h"
#include "tb/bench/beam_core_traffic.h"
#include "tb/twin/traffic_replay.h"
#include "tb/twin/twins.h"

namespace racebeam {
namespace {

constexpr int Frame = 4799;

/// Traffic in memory.
class Recording : public TrafficSink, public TrafficSource {
 public:
  void add(const std::uint64_t* row, bool is_private) override {
    if (blocks.empty() || blocks.back().is_private != is_private)
      blocks.push_back({clocks_, is_private, {}});
    blocks.back().values.insert(blocks.back().values.end(), row, row + head_.ports.size());
    clocks_ += !is_private;
  }
  void mark(std::int64_t frame) override { marks_.push_back({clocks_, frame}); }
  const TrafficHead& head() const override { return head_; }
  bool next(TrafficBlock& block) override {
    if (next_ == blocks.size()) return false;
    block = blocks[next_++];
    return true;
  }
  void rewind() override { next_ = 0; }
  std::vector<TrafficMark> marks() const override { return marks_; }
  std::uint64_t clocks() const override { return clocks_; }

  std::vector<TrafficBlock> blocks;
  TrafficHead head_;

 private:
  std::vector<TrafficMark> marks_;
  std::uint64_t clocks_ = 0;
  std::size_t next_ = 0;
};

class ChipTraffic : public testing::TestWithParam<const char*> {
 protected:
  ChipTraffic() {
    traffic_.head_.unit = GetParam();
    const engine& built = beam_engine();
    record_chip_traffic(
        {built, k_, nullptr, 12799}, GetParam(), {Frame},
        [&](const auto& ports) -> TrafficSink& {
          traffic_.head_.ports = ports;
          return traffic_;
        },
        [](int, std::uint64_t) {});
  }
  UnitUnderTest dut() const {
    const auto plugins = twins_of(beam_engine()).plugins(k_, nullptr, false);
    return {GetParam(), plugins.own(GetParam(), false), k_, nullptr, 12799};
  }

  const knob_values k_ = beam_engine().standard(nullptr);
  Recording traffic_;
};

TEST_P(ChipTraffic, RtlSaysWhatWasCaptured) {
  const auto rtl = play_rtl(dut(), traffic_.head());
  const ReplayDone done = replay(traffic_, *rtl, [](std::uint64_t) {});
  EXPECT_FALSE(done.difference) << "clock " << *done.difference;
  EXPECT_EQ(done.clocks, 840001u);
}

TEST_P(ChipTraffic, CoresMakeTheSame) {
  BeamCoreTraffic cores(traffic_.head(), knobs(k_), nullptr, Frame, 1);
  EXPECT_EQ(cores.clocks(), traffic_.clocks());
  EXPECT_EQ(cores.marks().at(0).clock, traffic_.marks().at(0).clock);
  const std::size_t ports = traffic_.head().ports.size();
  std::vector<std::uint64_t> wired[2], made[2];  // not private, and private
  TrafficBlock block;
  while (traffic_.next(block))
    wired[block.is_private].insert(wired[block.is_private].end(), block.values.begin(),
                                   block.values.end());
  while (cores.next(block))
    made[block.is_private].insert(made[block.is_private].end(), block.values.begin(),
                                  block.values.end());
  for (const int own : {0, 1}) {
    ASSERT_EQ(made[own].size(), wired[own].size()) << (own ? "private" : "");
    // In the first clock, that of power-up, a wired model has not driven what only registers move;
    // the outputs of private clocks mean nothing.
    for (std::size_t n = own ? 0 : ports; n < made[own].size(); ++n)
      if (made[own][n] != wired[own][n] && (!own || traffic_.head().ports[n % ports].input))
        FAIL() << traffic_.head().ports[n % ports].name << " in clock " << n / ports << ": "
               << made[own][n] << " instead of " << wired[own][n] << (own ? ", private" : "");
  }
}

INSTANTIATE_TEST_SUITE_P(Beam, ChipTraffic,
                         testing::Values("vga_timing", "sequencer", "camera_unit", "ray_stepper",
                                         "subdivider", "stacks", "decision_datapath", "scene",
                                         "navigator", "interval_fifo", "pixel_output", "pwm_sound"),
                         [](const auto& unit) { return std::string(unit.param); });

}  // namespace
}  // namespace racebeam
