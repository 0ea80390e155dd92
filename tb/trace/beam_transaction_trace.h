// TransactionTrace: what the `tlm` level does as transactions of a VCD, one signal for each stream.
//
// tlm.tracer.line      a scan line: from the tracer's first clock on it to the one in which the
//                      FIFO takes its last interval, or to the last but one of the line if it never
//                      does
// tlm.tracer.interval  pixels, colour index, room and rooms entered: from the clock after the one
//                      before was taken to the one in which the FIFO takes it; "not taken" is what
//                      the line had no time for
// tlm.tracer.room      the room that the tracer is in, as room_q says, and how many it has entered
//                      on the way (chip_observer.h); none on line 251, the navigator's
// tlm.tracer.restart   an underflow restart, with the pixel it goes on from: from its clock to the
//                      one in which the FIFO takes the next interval: what it may have cost
// tlm.display.shown    a run of one colour on the screen, r g b 0..3 each
// tlm.display.line     a write to display_socket: from the first clock of the line that it carries
//                      to the line's end, the time it is annotated with
// tlm.display.frame    the same of a frame
//
// A signal is "-" while no transaction is on. Transactions of a stream that follow each other
// without a gap differ in their texts: each names its place. `beam` has frame, line and part; pixel
// and clock would change in every clock and are left out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sc/beam/tlm/chip_observer.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_window.h"
#include "tb/wave/vcd_writer.h"

namespace racebeam {

class TransactionTrace final : public chip_observer {
 public:
  /// Adds its signals to `vcd`, which outlives it. `part`: what a frame shows. Throws UsageError if
  /// nothing is selected.
  TransactionTrace(const Raster& raster, int period_ps, const TraceSelection& selection,
                   std::function<std::string(int)> part, VcdWriter& vcd);

  /// What is told from now on belongs to `frame`; of it only the clocks of `window` are kept.
  void begin_frame(int frame, const TraceWindow& window);
  /// A write to the display (tlm_map.h), annotated with the beginning of clock `end` of the frame.
  void written(int end, std::uint64_t address, const std::uint8_t* data, unsigned bytes);
  /// Writes the frame to the VCD.
  void end_frame();

  void started(int y, int clock) override;
  void entered(int y, int clock, int room, int depth) override;
  void interval(const taken_interval& taken) override;
  void restart(int y, int clock, int pixel) override;
  void shown(int y, int column, int count, int colour) override;
  void line_end(int y, int decisions) override;

 private:
  enum Stream { Line, Interval, Room, Restart, Shown, DisplayedLine, DisplayedFrame, Streams };
  static constexpr int None = -1;

  struct Transaction {
    int begin, end;  ///< clocks of the frame; `end` is not in it
    std::string text;
  };
  struct Change {
    int clock, signal;
    const std::string* text;
  };
  void add(Stream stream, int begin, int end, const std::string& text);
  void add_run();
  void end_room(int end);
  void end_restart(int end);
  std::vector<Change> changes() const;
  /// Clock of the frame.
  int clock_of(int y, int clock) const { return (y - FirstLine) * raster_.line_clocks() + clock; }

  const Raster& raster_;
  const std::uint64_t period_;
  const std::function<std::string(int)> part_;
  VcdWriter& vcd_;
  std::vector<int> column_clocks_;  // of a line, in which visible columns end
  int frame_signal_, line_signal_, part_signal_;
  std::array<int, Streams> signals_{};
  std::array<std::vector<Transaction>, Streams> transactions_;

  int frame_ = 0, from_ = 0, to_ = 0;                   // the frame's clocks in the window
  int line_begin_ = None;                               // while the tracer is on a line
  int interval_begin_ = 0, next_ = 0;                   // what it works on: since when, first pixel
  int room_begin_ = 0, room_ = None, depth_ = 0;        // where it is
  int restart_begin_ = 0, restart_ = None;              // pixel that it goes on from
  int run_y_ = 0, run_ = 0, run_end_ = 0, colour_ = 0;  // columns of one colour, not added yet
};

}  // namespace racebeam
