// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/wired_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "sc/base/constants.h"
#include "sc/swap/channel_delays.h"
#include "sc/swap/channel_stalls.h"
#include "sc/swap/rtl_parameters.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/simulate.h"
#include "tb/bench/benches.h"
#include "tb/bench/hang_watch.h"
#include "tb/bench/rising_clock.h"
#include "tb/monitor/pin_probe.h"
#include "tb/twin/engine_raster.h"
#include "tb/twin/lockstep_report.h"

namespace racebeam {

namespace {

/// Of a chip whose pictures are not frames, between two seek().
constexpr int UnknownPicture = -1;
/// After such a picture, to show it: the monitor gets the end of the first one with the second.
constexpr int WholeFrames = 2;

/// Looks at the settled wires of every clock, at the edge that ends it.
class EdgeProbe : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};

  explicit EdgeProbe(const sc_core::sc_module_name& name, std::function<void()> look)
      : sc_module(name), look_(std::move(look)) {
    SC_HAS_PROCESS(EdgeProbe);
    SC_METHOD(sample);
    sensitive << clk_i.pos();
    dont_initialize();
  }

 private:
  void sample() {
    if (!std::exchange(in_reset_, false)) look_();
  }

  const std::function<void()> look_;
  bool in_reset_ = true;  // the first edge
};

}  // namespace

struct WiredBench::Platform {
  const Setting setting;
  const Watches watches;
  const sc_core::sc_time period;
  const Raster raster;
  rising_clock clk;
  wire<1> rst_n{"rst_n"}, pwm{"pwm"};
  wire<8> uo{"uo"};
  wire<1> hsync_n{"hsync_n"}, vsync_n{"vsync_n"};
  wire<DacProbe::Bits> red{"red"}, green{"green"}, blue{"blue"};
  const std::unique_ptr<wired_chip> dut;
  channel_stalls* const stalls;  // nullptr: nothing stalls
  VgaFrame picture;
  VgaMonitor vga;
  std::unique_ptr<SoundMonitor> sound;
  PinProbe pins;
  DacProbe dac;
  std::unique_ptr<Surroundings> around;  // nullptr: nothing
  std::vector<std::unique_ptr<EdgeProbe>> probes;
  std::vector<std::unique_ptr<Lockstep>> locksteps;
  std::unique_ptr<HangWatch> hang;  // nullptr: models only, which do not hang
  int next_frame = 0;
  int frame_clock = 0;  // of the frame that is being simulated
  std::uint64_t clocks = 0;

  std::function<void()> look;
  int looks = 0;  // how often it was changed

  std::exception_ptr thrown;  // by look

  Lockstep& put_beside(const std::string& name, const std::string& unit,
                       const sc_core::sc_module& model);
  void put_all_beside();
  void probe(std::function<void()> see);
  void look_each_clock();
  std::string place_now(const sc_core::sc_time& begin) const;
  void start(const sc_core::sc_time& time);
  void end_clock() {
    if (watches.stats) dut->count();
    if (around) around->clock();
  }
  void watch_hangs();
  void check_hang() const;
  std::string last_progress() const;
  bool tiny_vga() const { return dut->video().bits == TinyVga.bits; }

  Platform(const Setting& s, const Watches& w)
      : setting(s),
        watches(w),
        period(clock_period_ps(s.built.video(s.k).clocks_per_pixel), sc_core::SC_PS),
        raster(raster_of(s.built, s.k)),
        clk("clk", period),
        dut(s.built.make_signal("chip", s.k, s.scene, s.units)),
        stalls(channel_stalls::of(*dut)),
        vga(
            raster, [this](const VgaFrame& f) { picture = f; }, {w.crc, w.crc}, nullptr,
            tiny_vga() ? TinyVga : converter_pinout(dut->video().bits)),
        sound(w.sound ? new SoundMonitor : nullptr),
        pins("pins", period, period, tiny_vga() ? &vga : nullptr, sound.get()),
        dac("dac", (1 + dut->video().delay) * period, period, tiny_vga() ? nullptr : &vga) {
    dut->connect({clk, rst_n, uo, pwm, hsync_n, vsync_n, red, green, blue});
    pins.uo_i(uo);
    pins.pwm_i(pwm);
    dac.hsync_ni(hsync_n);
    dac.vsync_ni(vsync_n);
    dac.red_i(red);
    dac.green_i(green);
    dac.blue_i(blue);
    if (const auto make = bench_of(s.built).around) around = make(*dut, s);
    if (around && w.crc) around->rest(WholeFrames);
    if (w.stats || around) probe([this] { end_clock(); });
    if (w.each_edge) probe([this] { watches.each_edge(*dut); });
    put_all_beside();
    watch_hangs();

    // One edge in reset, after all wires have settled; then we stand inside the first clock of
    // frame 0, and after each frame inside the first clock of the next.
    simulate(period * 1.25);
    dut->set_pins();
    rst_n.write(true);
    if (around) around->seek(0);
    if (stalls) stalls->begin(0);
  }
};

void WiredBench::Platform::probe(std::function<void()> see) {
  const std::string name = "probe_" + std::to_string(probes.size());
  probes.push_back(std::make_unique<EdgeProbe>(name.c_str(), std::move(see)));
  probes.back()->clk_i(clk);
}

Lockstep& WiredBench::Platform::put_beside(const std::string& name, const std::string& unit,
                                           const sc_core::sc_module& model) {
  locksteps.push_back(std::make_unique<Lockstep>(("lockstep_" + name).c_str(), unit, model,
                                                 setting.built.parameters(setting.k),
                                                 setting.units.of(unit).plugin));
  locksteps.back()->clk_i(clk);
  if (watches.outlive_faults) locksteps.back()->outlive_faults();
  return *locksteps.back();
}

// Puts the RTL beside the models that are to run in lockstep.
void WiredBench::Platform::put_all_beside() {
  const engine& built = setting.built;
  for (const std::string& unit : built.unit_names(setting.scene != nullptr)) {
    if (!setting.units.of(unit).lockstep) continue;
    const std::string name = std::string(dut->name()) + "." + built.unit(unit)->path();
    for (const auto* module : dut->modules())
      if (module->name() == name) put_beside(unit, unit, *module);
  }
  if (!setting.units.of(built.top).lockstep) return;
  Lockstep& top = put_beside("top", built.top, *dut);
  // With registers in its wires the chip has others than a top in RTL.
  if (!channel_delays::of(*dut)) top.check_wiring(*dut);
}

void WiredBench::Platform::watch_hangs() {
  const auto is_rtl = [](const auto& one) { return one.second.driver == unit_choice::Rtl; };
  const auto& chosen = setting.units.by_unit;
  if (std::any_of(chosen.begin(), chosen.end(), is_rtl))
    hang = std::make_unique<HangWatch>(*dut, setting.k, waits_of(setting.built),
                                       clk.posedge_event(), period, raster.line_clocks(),
                                       stalls || channel_delays::of(*dut));
}

void WiredBench::Platform::check_hang() const {
  if (!hang->hangs(around && (!around->busy() || around->sends()))) return;
  const std::string seen =
      hang->stands()
          ? fmt::format("the last time that {} was {}", hang->kind().what, last_progress())
          : fmt::format("{} has not risen for {} clocks", hang->kind().rare.front(),
                        hang->rare_clocks());
  throw RtlFault("the chip makes no progress: " + seen + "\n" + hang->chain());
}

std::string WiredBench::Platform::last_progress() const {
  const auto ago = static_cast<long long>(hang->clocks());
  const long long at = frame_clock - ago;
  if (around) return fmt::format("{} clocks ago", ago);
  if (at < 0) return fmt::format("before frame {}, {} clocks ago", next_frame, ago);
  return fmt::format("in frame {}, line {}, clock {}, {} clocks ago", next_frame,
                     raster.first_line + at / raster.line_clocks(), at % raster.line_clocks(), ago);
}

WiredBench::WiredBench(const Setting& setting) : WiredBench(setting, {}) {}
WiredBench::WiredBench(const Setting& setting, const Watches& watches)
    : platform_(new Platform(setting, watches)) {}
WiredBench::~WiredBench() = default;

void WiredBench::seek(int frame) {
  Platform& p = *platform_;
  if (frame == p.next_frame) return;
  if (p.around && p.around->busy()) {
    p.around->stop();
    do advance(p.raster.frame_clocks());
    while (p.around->busy());
  }
  p.dut->deposit(frame);
  for (auto& lockstep : p.locksteps)
    lockstep->deposit(
        [&](rtl_instance& rtl) { p.dut->deposit_beside(lockstep->unit(), rtl, frame); });
  if (p.around) p.around->seek(frame);
  if (p.stalls) p.stalls->begin(static_cast<std::uint64_t>(frame));
  p.next_frame = frame;
}

void WiredBench::advance(int clocks) {
  Platform& p = *platform_;
  // What stalls in a frame does not depend on the frames before it.
  if (p.stalls && !p.around && p.frame_clock == 0)
    p.stalls->begin(static_cast<std::uint64_t>(p.next_frame));
  const int end = p.frame_clock + std::min(clocks, p.raster.frame_clocks() - p.frame_clock);
  for (bool begins = true; p.frame_clock < end; begins = false) {
    if (!begins && interrupted()) throw Interrupted();
    const int count = std::min(end - p.frame_clock, p.raster.line_clocks());
    p.start(count * p.period);
    p.clocks += count;
    p.frame_clock += count;
    if (p.hang) p.check_hang();
  }
  if (p.frame_clock < p.raster.frame_clocks()) return;
  p.frame_clock = 0;
  p.next_frame = p.around ? UnknownPicture : (p.next_frame + 1) % p.setting.frames;
  p.pins.advance();
  p.dac.advance();
}

WiredBench::Frame WiredBench::render() {
  Platform& p = *platform_;
  const int number = p.next_frame;
  const int pictures = p.around ? p.around->pictures() : 0;
  do advance(p.raster.frame_clocks());
  while (p.around && p.around->pictures() == pictures);
  for (int n = 0; p.around && p.watches.crc && n < WholeFrames; ++n)
    advance(p.raster.frame_clocks());
  Frame frame{number, p.picture, {}, {}};
  if (p.watches.stats) frame.stats = p.dut->take_counts();
  return frame;
}

const Surroundings* WiredBench::around() const { return platform_->around.get(); }

void WiredBench::settle() {
  while (sc_core::sc_pending_activity_at_current_time()) platform_->start(sc_core::SC_ZERO_TIME);
  for (auto& lockstep : platform_->locksteps) lockstep->settle();
}

/// Where the beam was when RTL ended, in a run that began at `begin`, a quarter into its clock.
std::string WiredBench::Platform::place_now(const sc_core::sc_time& begin) const {
  const int clock = frame_clock + static_cast<int>((sc_core::sc_time_stamp() - begin) / period);
  const int line = raster.first_line + clock / raster.line_clocks();
  return " (" + place_text({next_frame, line, clock % raster.line_clocks()}, raster) + ")";
}

void WiredBench::Platform::start(const sc_core::sc_time& time) {
  const sc_core::sc_time begin = sc_core::sc_time_stamp();
  try {
    simulate(time);
  } catch (const RtlFault& fault) {
    if (next_frame == UnknownPicture) throw;
    throw RtlFault(fault.what() + place_now(begin));
  }
  if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
}

void WiredBench::each_clock(std::function<void()> look) {
  platform_->look = std::move(look);
  ++platform_->looks;
  if (platform_->look) platform_->look_each_clock();
}

// A process that wakes itself as long as nobody else is to look.
void WiredBench::Platform::look_each_clock() {
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

void WiredBench::watch_registers() {
  for (auto* module : platform_->dut->modules())
    if (auto* unit = dynamic_cast<probed*>(module)) unit->watch();
}

void WiredBench::forget_differences() {
  for (auto& lockstep : platform_->locksteps) lockstep->forget();
}

const wired_chip& WiredBench::dut() const { return *platform_->dut; }

std::vector<const Lockstep*> WiredBench::locksteps() const {
  std::vector<const Lockstep*> all;
  for (const auto& lockstep : platform_->locksteps) all.push_back(lockstep.get());
  return all;
}

std::uint64_t WiredBench::invert(const std::string& unit, const std::string& port, int bit) {
  for (const auto& lockstep : platform_->locksteps)
    if (lockstep->unit() == unit) {
      lockstep->invert(port, bit, lockstep->clocks());
      return lockstep->clocks();
    }
  throw std::invalid_argument(unit + " does not run in lockstep");
}

int WiredBench::period_ps() const {
  return clock_period_ps(platform_->setting.built.video(platform_->setting.k).clocks_per_pixel);
}

std::uint64_t WiredBench::clocks() const { return platform_->clocks; }
const SoundMonitor* WiredBench::sound() const { return platform_->sound.get(); }

}  // namespace racebeam
