// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/tlm_bench.h"

#include <zlib.h>

#include <algorithm>
#include <exception>

#include "sc/beam/tlm/tlm_chip.h"
#include "tb/bench/interval_log.h"
#include "tb/monitor/raster.h"

namespace racebeam {

namespace {

/// A target that takes what the chip shows and plays.
class Screen : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<Screen> socket{"socket"};

  Screen(const sc_core::sc_module_name& name, const Raster& raster, bool crc, bool sound)
      : sc_module(name), raster_(raster), crc_(crc), sound_(sound ? new SoundMonitor : nullptr) {
    socket.register_b_transport(this, &Screen::take);
    picture_.colours.resize(VisibleColumns * VisibleRows);
    if (sound_) sound_->change(0, true);  // the level at power-up
  }

  /// The frame just shown.
  VgaFrame picture() {
    if (failure_) std::rethrow_exception(failure_);
    if (crc_)
      picture_.image_crc = static_cast<std::uint32_t>(
          crc32(0, picture_.colours.data(), static_cast<uInt>(picture_.colours.size())));
    return picture_;
  }
  const SoundMonitor* sound() const { return sound_.get(); }

 private:
  void take(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
    const std::uint64_t address = payload.get_address();
    const std::uint8_t* data = payload.get_data_ptr();
    const int bytes = static_cast<int>(payload.get_data_length());
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
    if (address < DisplayFrame) {
      std::copy_n(data, bytes, picture_.colours.begin() + static_cast<std::ptrdiff_t>(address));
    } else if (address == DisplayFrame) {
      end_frame();
    } else if (address < DisplaySound) {
      take_pins(line_begin(address - DisplayPins), data, bytes);
    } else {
      take_sound(line_begin(address - DisplaySound), data, bytes);
    }
  }

  std::uint64_t line_begin(std::uint64_t offset) const {
    return begin_ + offset / DisplayLinePitch * raster_.line_clocks();
  }

  void take_pins(std::uint64_t begin, const std::uint8_t* pins, int clocks) {
    if (failure_) return;
    try {
      for (int clock = 0; clock < clocks; ++clock)
        if (clock == 0 || pins[clock] != pins[clock - 1]) vga_.change(begin + clock, pins[clock]);
    } catch (...) {
      failure_ = std::current_exception();
    }
  }

  void take_sound(std::uint64_t begin, const std::uint8_t* words, int bytes) {
    for (int i = 0; i < bytes; i += 4) {
      const unsigned word = words[i] | words[i + 1] << 8 | words[i + 2] << 16 | words[i + 3] << 24;
      sound_->change(begin + (word >> 1), word & 1);
    }
  }

  void end_frame() {
    picture_.index = begin_ / raster_.frame_clocks();
    begin_ += raster_.frame_clocks();
    if (sound_) sound_->advance(begin_);
    if (!crc_ || failure_) return;
    try {
      vga_.advance(begin_);
    } catch (...) {
      failure_ = std::current_exception();
    }
  }

  const Raster raster_;
  const bool crc_;
  const std::unique_ptr<SoundMonitor> sound_;
  VgaFrame picture_;
  VgaMonitor vga_{
      raster_, [this](const VgaFrame& f) { picture_.pins_crc = f.pins_crc; }, {false, true}};
  std::uint64_t begin_ = 0;  // clock 0 of the frame
  std::exception_ptr failure_;
};

}  // namespace

struct TlmBench::Platform {
  const Options options;
  const Raster raster;
  const sc_core::sc_time period, frame_time;
  IntervalLog log;
  tlm_chip dut;
  Screen screen;
  int next_frame = 0;

  explicit Platform(const Options& o)
      : options(o),
        raster(o.k.clocks_per_pixel, o.k.speed),
        period(clock_period_ps(o.k.clocks_per_pixel), sc_core::SC_PS),
        frame_time(raster.frame_clocks() * period),
        dut("chip", {o.k, o.program, o.crc, o.sound, o.intervals ? &log : nullptr}),
        screen("screen", raster, o.crc, o.sound) {
    tlm::tlm_global_quantum::instance().set(frame_time);
    dut.display_socket.bind(screen.socket);
    // The chip is in reset for a clock; we stand inside it, then in the last of each frame.
    sc_core::sc_start(period / 2);
  }
};

TlmBench::TlmBench(const Options& options) : platform_(new Platform(options)) {}
TlmBench::~TlmBench() = default;

void TlmBench::seek(int frame) {
  if (frame == platform_->next_frame) return;
  platform_->dut.deposit(frame);
  platform_->next_frame = frame;
}

TlmBench::Frame TlmBench::render() {
  Platform& p = *platform_;
  sc_core::sc_start(p.frame_time);
  Frame frame{p.next_frame, p.screen.picture(), {}};
  if (p.options.stats) frame.stats = counted(p.dut.stats());
  frame.intervals = p.log.take();
  p.next_frame = p.dut.lines().next_frame();
  return frame;
}

std::uint64_t TlmBench::clocks() const { return platform_->dut.clocks(); }
const SoundMonitor* TlmBench::sound() const { return platform_->screen.sound(); }

}  // namespace racebeam
