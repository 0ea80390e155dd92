// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/unit_traffic.h"

#include <algorithm>
#include <exception>

#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/scene/engines.h"
#include "tb/twin/random_episodes.h"
#include "tb/twin/traffic_tap.h"
#include "tb/twin/twins.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Batch = 10000;  // clocks, then it looks

/// Listens at each rising edge.
class EdgeTap : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};

  EdgeTap(const sc_core::sc_module_name& name, TrafficTap& tap) : sc_module(name), tap_(tap) {
    SC_HAS_PROCESS(EdgeTap);
    SC_METHOD(edge);
    sensitive << clk_i.pos();
    dont_initialize();
  }
  void check() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  void edge() {  // the kernel would make something else of an exception
    if (thrown_) return;
    try {
      tap_.edge();
    } catch (...) {
      thrown_ = std::current_exception();
    }
  }

  TrafficTap& tap_;
  std::exception_ptr thrown_;
};

}  // namespace

void record_lone_traffic(
    const UnitUnderTest& dut, LoneTraffic kind, std::uint64_t clocks, unsigned seed,
    const std::function<TrafficSink&(const std::vector<PortTraffic::Port>&)>& open,
    const std::function<void(std::uint64_t)>& done) {
  const engine& built = engine_of(dut.k);
  const auto model = built.unit(dut.unit)->make("model", dut.k, dut.scene);
  TrafficTap tap(dut.unit, *model, open(traffic_ports(*model)));
  EdgeTap edges("tap", tap);
  UnitBench bench(*model, &edges.clk_i);
  const auto traffic = random_traffic(dut, bench, seed);
  seek_at_episodes(*traffic, *model, dut.frames, [&tap](int frame) {
    tap.deposit([frame](rtl_instance& rtl) { rtl.seek(frame); });
  });
  if (kind == LoneTraffic::Random) bench.between_edges([&] { traffic->next(); });
  else bench.between_edges(twins_of(built).walk(dut.unit)->begin(bench, dut.k, seed));
  for (std::uint64_t ready = 0; ready < clocks;) {
    if (interrupted()) throw Interrupted();
    const std::uint64_t some = std::min(Batch, clocks - ready);
    bench.clock(static_cast<int>(some));
    edges.check();
    done(ready += some);
  }
}

PortTraffic record_from_reset(const UnitUnderTest& dut, std::uint64_t clocks, unsigned seed) {
  const engine& built = engine_of(dut.k);
  const auto model = built.unit(dut.unit)->make("model", dut.k, dut.scene);
  UnitBench bench(*model);
  const auto random = random_traffic(dut, bench, seed);
  PortTraffic traffic = traffic_of(dut.unit, bench);
  for (std::uint64_t clock = 0; clock < clocks && !interrupted(); ++clock) {
    if (clock > 0) random->next();  // before it, the inputs reset
    bench.settle();
    traffic.append(bench);
    bench.clock();
  }
  return traffic;
}

}  // namespace racebeam
