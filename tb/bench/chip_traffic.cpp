// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/chip_traffic.h"

#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "sc/base/constants.h"
#include "tb/bench/surroundings.h"
#include "tb/twin/engine_raster.h"
#include "tb/twin/traffic_tap.h"

namespace racebeam {

namespace {

constexpr int UnknownFrame = -1;

/// A tap on a chip that is built after it: it begins with the edge in reset, which comes while the
/// bench is made.
class EarlyTap {
 public:
  EarlyTap(const WiredBench::Setting& setting, std::string unit, OpenSink open)
      : unit_(std::move(unit)),
        path_(std::string("chip.") + setting.built.unit(unit_)->path()),
        open_(std::move(open)) {
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
      if (!tap_) put_on();
      tap_->edge();
    } catch (...) {
      thrown_ = std::current_exception();
    }
  }
  void begin(const wired_chip& chip, int frame, bool sought) {
    check();
    if (sought) tap_->deposit([&](rtl_instance& rtl) { chip.deposit_beside(unit_, rtl, frame); });
    sink_->mark(frame);
  }
  void check() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  // Called at the start, and then as the clock rises: before anybody sees it.
  void first_edge(const sc_core::sc_time& at) {
    if (sc_core::sc_time_stamp() == at) edge();
    else sc_core::next_trigger(at);
  }
  void put_on() {
    const auto* module =
        dynamic_cast<const sc_core::sc_module*>(sc_core::sc_find_object(path_.c_str()));
    if (!module) throw std::logic_error("there is no module " + path_);
    sink_ = &open_(traffic_ports(*module));
    tap_.emplace(unit_, *module, *sink_);
  }

  const std::string unit_, path_;
  const OpenSink open_;
  TrafficSink* sink_ = nullptr;
  std::optional<TrafficTap> tap_;
  std::exception_ptr thrown_;
};

}  // namespace

void record_chip_traffic(const WiredBench::Setting& setting, const std::string& unit,
                         const std::vector<int>& frames, const OpenSink& open,
                         const std::function<void(int frames, std::uint64_t clocks)>& done) {
  EarlyTap tap(setting, unit, open);
  WiredBench::Watches watches;
  watches.each_edge = [&](const wired_chip&) { tap.edge(); };
  WiredBench bench(setting, watches);
  const int clocks = raster_of(setting.built, setting.k).frame_clocks();
  int next = 0, ready = 0;
  for (const int frame : frames) {
    bench.seek(frame);
    tap.begin(bench.dut(), frame, frame != next);
    const Surroundings* around = bench.around();
    const int pictures = around ? around->pictures() : 0;
    do {
      bench.advance(clocks);
      tap.check();
    } while (around && around->pictures() == pictures);
    next = around ? UnknownFrame : (frame + 1) % setting.frames;
    done(++ready, bench.clocks());
  }
}

}  // namespace racebeam
