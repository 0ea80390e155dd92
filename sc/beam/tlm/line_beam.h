// line_beam: interval_fifo and the pixels on show, caught up with only when the tracer asks.
//
// Between two offers the FIFO changes at few clocks: when an entry is used up, or the head sheds
// one. Those are clocked by interval_fifo_core; whole runs of pixels between them are counted down
// at once. Fills the row of pixels, counts the FIFO's fill and starved pixels, tells the observer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sc/beam/frame_stats.h"
#include "sc/beam/interval_fifo.h"
#include "sc/beam/tlm/chip_observer.h"
#include "sc/beam/tlm/line_raster.h"

namespace racebeam {

/// Colours by what the FIFO shows; [1] of the pixels whose column plus line is odd.
using shown_colours = std::array<std::array<std::uint8_t, 2 * HalfTone>, 2>;

class line_beam {
 public:
  line_beam(const knobs& k, const line_raster& raster, interval_fifo_core& fifo)
      : knobs_(k), raster_(raster), fifo_(fifo) {}

  /// What is wanted of a line; nothing where a pointer is nullptr.
  struct wishes {
    int y;
    std::uint8_t* row;  ///< 640 pixels in the colours of what is on display; nullptr, too, where a
                        ///< pattern may hide them
    const shown_colours* colours;
    frame_stats* stats;
    chip_observer* observer;
    std::uint8_t* indices;  ///< what is on display in every clock
  };
  /// To the first clock of a line.
  void begin(const wishes& w) {
    wishes_ = w;
    now_ = column_ = 0;
  }
  /// From the first clock of a line to another: the FIFO is in reset.
  void hold(int clock);
  /// To a clock of the line, without an offer.
  void advance(int clock);
  /// An offer in a clock; whether it is accepted. If so the clock is done.
  bool offer(int clock, int len_m1, int value);
  /// The clock from which on the FIFO starves if nothing is taken in; may be after the line.
  int starves_from() const;
  /// After an offer that was not accepted: the next clock in which the same one may be.
  int offer_again() const;
  /// Column that is shown next, and the clock in which it is consumed.
  int column() const { return column_; }
  /// Nothing is left to show in the clock advanced to.
  bool starving() const { return fifo_.starving(knobs_); }
  /// What is on display in the clock advanced to: an index, with HalfTone.
  int display() const { return fifo_.display(knobs_); }

 private:
  bool consumes() const {
    return column_ < VisibleColumns && now_ == raster_.column_clock[column_];
  }
  int column_end(int column) const {
    return column < VisibleColumns ? raster_.column_clock[column] + 1 : raster_.size();
  }
  void step(const interval_fifo_core::inputs& in);
  int starved(int columns) const;
  void show(int columns, int starved);
  void draw(int columns, std::uint8_t colour);
  void pass(int until);

  const knobs knobs_;
  const line_raster& raster_;
  interval_fifo_core& fifo_;
  wishes wishes_{};
  int now_ = 0;     // the FIFO's registers are those of this clock
  int column_ = 0;  // the first that is not yet consumed
};

}  // namespace racebeam
