// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/chip_traffic.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>

#include "sc/base/constants.h"
#include "tb/bench/surroundings.h"
#include "tb/twin/engine_raster.h"
#include "tb/twin/traffic_tap.h"

namespace racebeam {

namespace {

constexpr int UnknownFrame = -1;
constexpr std::uint64_t Batch = 100'000;  // clocks, then it looks

/// Traffic that stays in memory.
struct KeptTraffic : TrafficSink {
  PortTraffic traffic;

  void add(const std::uint64_t* row, bool) override {
    traffic.values.insert(traffic.values.end(), row, row + traffic.ports.size());
  }
  void mark(std::int64_t) override {}
};

using OpenSinks =
    std::function<TrafficSink&(std::size_t unit, const std::vector<PortTraffic::Port>& ports)>;

/// Taps on a chip that is built after them: they begin with the edge in reset, which comes while
/// the bench is made.
class EarlyTaps {
 public:
  EarlyTaps(const WiredBench::Setting& setting, const std::vector<std::string>& units,
            OpenSinks open)
      : open_(std::move(open)) {
    for (const std::string& unit : units) {
      const bool whole = unit == setting.built.top;
      taps_.push_back(
          {unit, whole ? "chip" : "chip." + setting.built.unit(unit)->path(), nullptr, {}});
    }
    const sc_core::sc_time first(clock_period_ps(setting.built.video(setting.k).clocks_per_pixel),
                                 sc_core::SC_PS);
    sc_core::sc_spawn_options process;
    process.spawn_method();
    sc_core::sc_spawn([this, first] { first_edge(first); }, "first_edge", &process);
  }

  // The kernel would make something else of an exception.
  void edge() {
    if (thrown_) return;
    try {
      for (std::size_t n = 0; n < taps_.size(); ++n) {
        if (!taps_[n].tap) put_on(n);
        taps_[n].tap->edge();
      }
    } catch (...) {
      thrown_ = std::current_exception();
    }
  }
  void begin(const wired_chip& chip, int frame, bool sought) {
    check();
    for (Tap& one : taps_) {
      if (sought)
        one.tap->deposit([&](rtl_instance& rtl) { chip.deposit_beside(one.unit, rtl, frame); });
      one.sink->mark(frame);
    }
  }
  void check() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  struct Tap {
    std::string unit, path;
    TrafficSink* sink;
    std::unique_ptr<TrafficTap> tap;
  };
  // Called at the start, and then as the clock rises: before anybody sees it.
  void first_edge(const sc_core::sc_time& at) {
    if (sc_core::sc_time_stamp() == at) edge();
    else sc_core::next_trigger(at);
  }
  void put_on(std::size_t number) {
    Tap& one = taps_[number];
    const auto* module =
        dynamic_cast<const sc_core::sc_module*>(sc_core::sc_find_object(one.path.c_str()));
    if (!module) throw std::logic_error("there is no module " + one.path);
    one.sink = &open_(number, traffic_ports(*module));
    one.tap = std::make_unique<TrafficTap>(one.unit, *module, *one.sink);
  }

  const OpenSinks open_;
  std::vector<Tap> taps_;
  std::exception_ptr thrown_;
};

}  // namespace

PortTraffic traffic_from_power_up(const WiredBench::Setting& setting, const std::string& unit,
                                  std::uint64_t clocks) {
  KeptTraffic kept;
  EarlyTaps taps(setting, {unit},
                 [&](std::size_t, const std::vector<PortTraffic::Port>& ports) -> TrafficSink& {
                   kept.traffic = {unit, ports, {}};
                   return kept;
                 });
  WiredBench::Watches watches;
  watches.each_edge = [&](const wired_chip&) { taps.edge(); };
  WiredBench bench(setting, watches);
  while (kept.traffic.clocks() < clocks) {
    bench.advance(static_cast<int>(std::min<std::uint64_t>(Batch, clocks - kept.traffic.clocks())));
    taps.check();
  }
  return kept.traffic;
}

void record_chip_traffic(const WiredBench::Setting& setting, const std::string& unit,
                         const std::vector<int>& frames, const OpenSink& open,
                         const std::function<void(int frames, std::uint64_t clocks)>& done) {
  record_chip_traffic(
      setting, std::vector<std::string>{unit}, frames,
      [&](std::size_t, const std::vector<PortTraffic::Port>& ports) -> TrafficSink& {
        return open(ports);
      },
      done);
}

void record_chip_traffic(const WiredBench::Setting& setting, const std::vector<std::string>& units,
                         const std::vector<int>& frames, const OpenSinks& open,
                         const std::function<void(int frames, std::uint64_t clocks)>& done) {
  EarlyTaps taps(setting, units, open);
  WiredBench::Watches watches;
  watches.each_edge = [&](const wired_chip&) { taps.edge(); };
  WiredBench bench(setting, watches);
  const int clocks = raster_of(setting.built, setting.k).frame_clocks();
  int next = 0, ready = 0;
  for (const int frame : frames) {
    bench.seek(frame);
    taps.begin(bench.dut(), frame, frame != next);
    const Surroundings* around = bench.around();
    const int pictures = around ? around->pictures() : 0;
    do {
      bench.advance(clocks);
      taps.check();
    } while (around && around->pictures() == pictures);
    next = around ? UnknownFrame : (frame + 1) % setting.frames;
    done(++ready, bench.clocks());
  }
}

}  // namespace racebeam
