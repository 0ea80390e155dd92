// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/beam_transaction_bench.h"

#include <algorithm>
#include <utility>

#include "sc/beam/tlm/tlm_chip.h"

namespace racebeam {

namespace {

/// A target that takes no time; knows the clock of the frame that a write is annotated with.
class DisplayProbe : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<DisplayProbe> socket{"socket"};

  DisplayProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& period,
               TransactionTrace& trace)
      : sc_module(name), period_(period), trace_(trace) {
    socket.register_b_transport(this, &DisplayProbe::take);
  }
  void begin_frame(const sc_core::sc_time& begin) { begin_ = begin; }

 private:
  void take(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    const sc_core::sc_time at = sc_core::sc_time_stamp() + delay - begin_;
    trace_.written(static_cast<int>(at.value() / period_.value()), payload.get_address(),
                   payload.get_data_ptr(), payload.get_data_length());
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }

  const sc_core::sc_time period_;
  TransactionTrace& trace_;
  sc_core::sc_time begin_;  // of the frame
};

}  // namespace

struct TransactionBench::Platform {
  const Raster& raster;
  TransactionTrace trace;
  const sc_core::sc_time period, frame_time;
  tlm_chip dut;
  DisplayProbe display;

  Platform(const knobs& k, const scene_program* program, const Raster& r,
           const TraceSelection& selection, std::function<std::string(int)> part, VcdWriter& vcd)
      : raster(r),
        trace(r, clock_period_ps(k.clocks_per_pixel), selection, std::move(part), vcd),
        period(clock_period_ps(k.clocks_per_pixel), sc_core::SC_PS),
        frame_time(r.frame_clocks() * period),
        dut("chip", {k, program, false, false, &trace}),
        display("display", period, trace) {
    tlm::tlm_global_quantum::instance().set(frame_time);
    dut.display_socket.bind(display.socket);
    sc_core::sc_start(period / 2);  // the chip is in reset for a clock; we stand inside it
  }
};

TransactionBench::TransactionBench(const knobs& k, const scene_program* program,
                                   const Raster& raster, const TraceSelection& selection,
                                   std::function<std::string(int)> part, VcdWriter& vcd)
    : platform_(new Platform(k, program, raster, selection, std::move(part), vcd)) {}
TransactionBench::~TransactionBench() = default;

std::int64_t TransactionBench::run(const TraceWindow& window, const std::function<bool()>& stop) {
  Platform& p = *platform_;
  const std::int64_t first = window.from.ordinal(p.raster);
  std::int64_t end = first;
  p.dut.deposit(window.from.frame);
  for (int frame = window.from.frame; frame <= window.to.frame && !stop(); ++frame) {
    p.trace.begin_frame(frame, window);
    p.display.begin_frame(p.period + (frame - window.from.frame) * p.frame_time);
    sc_core::sc_start(p.frame_time);
    p.trace.end_frame();
    end = std::min(TracePoint{frame + 1, FirstLine, 0}.ordinal(p.raster),
                   window.to.ordinal(p.raster) + 1);
  }
  return end - first;
}

}  // namespace racebeam
