// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/signal_bench.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

#include "sc/beam/chip.h"
#include "sc/beam/chip_core.h"
#include "sc/beam/knob_parameters.h"
#include "sc/beam/stats_collector.h"
#include "sc/beam/units.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/simulate.h"
#include "tb/bench/interval_watcher.h"
#include "tb/monitor/pin_probe.h"

namespace racebeam {

namespace {

/// Looks at the settled wires of every clock, at the edge that ends it.
class StatsProbe : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};

  StatsProbe(const sc_core::sc_module_name& name, const chip& dut,
             const SignalBench::Options& options)
      : sc_module(name),
        dut_(dut),
        stats_(options.stats),
        intervals_(options.intervals),
        watch_(options.watch) {
    SC_HAS_PROCESS(StatsProbe);
    SC_METHOD(sample);
    sensitive << clk_i.pos();
    dont_initialize();
  }
  frame_stats take() { return collector_.take(); }
  std::vector<IntervalEvent> take_intervals() { return watcher_.take(); }

 private:
  void sample() {
    if (std::exchange(in_reset_, false)) return;
    const chip_view view = dut_.view();
    if (stats_) collector_.observe(view);
    if (!intervals_ && !watch_) return;
    const int room = static_cast<int>(dut_.room.read());
    const int face = static_cast<int>(dut_.hit_face.read());
    if (intervals_) watcher_.observe(view, room, face);
    if (watch_) watch_->clock(static_cast<int>(dut_.uo_o->read()), view, room, face);
  }

  const chip& dut_;
  const bool stats_, intervals_;
  FrameWatch* const watch_;
  stats_collector collector_;
  IntervalWatcher watcher_;
  bool in_reset_ = true;  // the first edge
};

}  // namespace

struct SignalBench::Platform {
  const Options options;
  const sc_core::sc_time period;
  const Raster raster;
  sc_core::sc_clock clk;
  wire<1> rst_n{"rst_n"}, no_interlace{"no_interlace"}, pwm{"pwm"};
  wire<3> speed{"speed"};
  wire<8> uo{"uo"};
  chip dut;
  VgaFrame picture;
  VgaMonitor vga;
  std::unique_ptr<SoundMonitor> sound;
  PinProbe pins;
  std::unique_ptr<StatsProbe> stats;
  std::vector<std::unique_ptr<Lockstep>> locksteps;
  int next_frame = 0;
  int frame_clock = 0;  // of the frame that is being simulated
  std::uint64_t clocks = 0;

  std::function<void()> look;
  int looks = 0;  // how often it was changed

  std::exception_ptr thrown;  // by look

  void watch();
  void look_each_clock();
  void start(const sc_core::sc_time& time);

  explicit Platform(const Options& o)
      : options(o),
        period(clock_period_ps(o.k.clocks_per_pixel), sc_core::SC_PS),
        raster(o.k.clocks_per_pixel, o.k.speed),
        clk("clk", period, 0.5, period),
        dut("chip", o.k, o.program, o.units),
        vga(raster, [this](const VgaFrame& f) { picture = f; }, {o.crc, o.crc}),
        sound(o.sound ? new SoundMonitor : nullptr),
        pins("pins", period, period, &vga, sound.get()),
        stats(o.stats || o.intervals || o.watch ? new StatsProbe("stats", dut, o) : nullptr) {
    dut.clk_i(clk);
    dut.rst_ni(rst_n);
    dut.speed_i(speed);
    dut.no_interlace_i(no_interlace);
    dut.uo_o(uo);
    dut.pwm_o(pwm);
    pins.uo_i(uo);
    pins.pwm_i(pwm);
    if (stats) stats->clk_i(clk);
    watch();

    // One edge in reset, after all wires have settled; then we stand inside the first clock of
    // frame 0, and after each frame inside the first clock of the next.
    simulate(period * 1.25);
    speed.write(o.k.speed);
    no_interlace.write(!o.k.interlace);
    rst_n.write(true);
  }
};

// Puts the RTL beside the models that are to run in lockstep.
void SignalBench::Platform::watch() {
  for (const std::string& unit : chip_units(options.program != nullptr)) {
    const unit_choice& choice = options.units.of(unit);
    if (!choice.lockstep) continue;
    for (auto* child : dut.get_child_objects())
      if (child->basename() == instance_of(unit)) {
        locksteps.push_back(std::make_unique<Lockstep>(("lockstep_" + unit).c_str(), unit,
                                                       dynamic_cast<sc_core::sc_module&>(*child),
                                                       knob_parameters(options.k), choice.plugin));
        locksteps.back()->clk_i(clk);
      }
  }
  const unit_choice& top = options.units.of(WholeChip);
  if (top.lockstep) {
    locksteps.push_back(std::make_unique<Lockstep>("lockstep_top", WholeChip, dut,
                                                   knob_parameters(options.k), top.plugin));
    locksteps.back()->clk_i(clk);
    locksteps.back()->check_wiring(dut);
  }
  if (!options.outlive_faults) return;
  for (auto& lockstep : locksteps) lockstep->outlive_faults();
}

SignalBench::SignalBench(const Options& options) : platform_(new Platform(options)) {}
SignalBench::~SignalBench() = default;

void SignalBench::seek(int frame) {
  if (frame == platform_->next_frame) return;
  platform_->dut.deposit(frame);
  const navigator_core place = fly_to(frame, platform_->options.k, platform_->options.program);
  for (auto& lockstep : platform_->locksteps) {
    if (WiringCheck* wiring = lockstep->wiring()) {
      wiring->seek(frame, place.position_q, place.room_q);
      continue;
    }
    const std::string instance = instance_of(lockstep->unit());
    if (instance == "u_sequencer") lockstep->deposit_frame(frame);
    if (instance == "u_navigator") lockstep->deposit_place(place.position_q, place.room_q);
  }
  platform_->next_frame = frame;
}

void SignalBench::advance(int clocks) {
  Platform& p = *platform_;
  const int end = p.frame_clock + std::min(clocks, p.raster.frame_clocks() - p.frame_clock);
  for (bool begins = true; p.frame_clock < end; begins = false) {
    if (!begins && interrupted()) throw Interrupted();
    const int count = std::min(end - p.frame_clock, p.raster.line_clocks());
    p.start(count * p.period);
    p.clocks += count;
    p.frame_clock += count;
  }
  if (p.frame_clock < p.raster.frame_clocks()) return;
  p.frame_clock = 0;
  p.next_frame = (p.next_frame + 1) % (p.options.program ? p.options.program->frames : DemoFrames);
  p.pins.advance();
}

SignalBench::Frame SignalBench::render() {
  Platform& p = *platform_;
  const int number = p.next_frame;
  advance(p.raster.frame_clocks());
  Frame frame{number, p.picture, {}, {}};
  if (p.options.stats) frame.stats = p.stats->take();
  if (p.options.intervals) frame.intervals = p.stats->take_intervals();
  return frame;
}

void SignalBench::settle() {
  while (sc_core::sc_pending_activity_at_current_time()) platform_->start(sc_core::SC_ZERO_TIME);
  for (auto& lockstep : platform_->locksteps) lockstep->settle();
}

void SignalBench::Platform::start(const sc_core::sc_time& time) {
  simulate(time);
  if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
}

void SignalBench::each_clock(std::function<void()> look) {
  platform_->look = std::move(look);
  ++platform_->looks;
  if (platform_->look) platform_->look_each_clock();
}

// A process that wakes itself as long as nobody else is to look.
void SignalBench::Platform::look_each_clock() {
  sc_core::sc_spawn_options process;
  process.spawn_method();
  sc_core::sc_spawn(
      [this, mine = looks] {
        if (mine != looks) return;
        for (auto& lockstep : locksteps) lockstep->settle();
        try {
          look();
        } catch (...) {  // the kernel would make another one of it
          thrown = std::current_exception();
          return;
        }
        sc_core::next_trigger(period);
      },
      sc_core::sc_gen_unique_name("look"), &process);
}

void SignalBench::watch_registers() {
  for (auto* child : platform_->dut.get_child_objects())
    if (auto* unit = dynamic_cast<probed*>(child)) unit->watch();
}

void SignalBench::forget_differences() {
  for (auto& lockstep : platform_->locksteps) lockstep->forget();
}

const sc_core::sc_module& SignalBench::dut() const { return platform_->dut; }

std::vector<const Lockstep*> SignalBench::locksteps() const {
  std::vector<const Lockstep*> all;
  for (const auto& lockstep : platform_->locksteps) all.push_back(lockstep.get());
  return all;
}

int SignalBench::period_ps() const {
  return clock_period_ps(platform_->options.k.clocks_per_pixel);
}

std::uint64_t SignalBench::clocks() const { return platform_->clocks; }
const SoundMonitor* SignalBench::sound() const { return platform_->sound.get(); }

}  // namespace racebeam
