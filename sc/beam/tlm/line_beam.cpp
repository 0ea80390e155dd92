// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tlm/line_beam.h"

#include <algorithm>

namespace racebeam {

// Time goes on; the display stays.
void line_beam::pass(int until) {
  if (wishes_.stats) wishes_.stats->fifo_fill[fifo_.fill(knobs_)] += until - now_;
  if (wishes_.indices) std::fill(wishes_.indices + now_, wishes_.indices + until, display());
  now_ = until;
}

void line_beam::hold(int clock) {
  const int columns = raster_.columns_before[clock];
  show(columns, columns);
  pass(clock);
  fifo_.hold(columns, knobs_);
}

// The next columns show what is on display: nothing of their own while starved.
void line_beam::show(int columns, int starved) {
  if (wishes_.stats) {
    wishes_.stats->starved_pixels += starved;
    if (wishes_.row) wishes_.stats->seen_starved_pixels += starved;
  }
  const auto colour = [&] { return (*wishes_.colours)[(column_ ^ wishes_.y) & 1][display()]; };
  if (!wishes_.row) column_ += columns;
  else if (display() < HalfTone) draw(columns, colour());
  else
    for (; columns > 0; --columns) draw(1, colour());
}

void line_beam::draw(int columns, std::uint8_t colour) {
  std::fill_n(wishes_.row + column_, columns, colour);
  if (wishes_.observer) wishes_.observer->shown(wishes_.y, column_, columns, colour);
  column_ += columns;
}

// Of the next columns, if nothing is taken in.
int line_beam::starved(int columns) const {
  if (!fifo_.head_only(knobs_)) return 0;
  return columns - std::clamp(fifo_.head_len_q + 1, 0, columns);
}

// One clock.
void line_beam::step(const interval_fifo_core::inputs& in) {
  if (in.consume) show(1, starved(1));
  pass(now_ + 1);
  fifo_.clock(in, knobs_);
}

void line_beam::advance(int clock) {
  while (now_ < clock) {
    if (fifo_.splitting(knobs_)) {
      step({false, consumes(), false, 0, 0});
      continue;
    }
    const int before = raster_.columns_before[clock] - column_;  // columns to be consumed
    const int quiet = std::min(before, fifo_.quiet_pixels(knobs_));
    if (quiet > 0) {
      show(quiet, starved(quiet));
      pass(column_end(column_ - 1));
      fifo_.count_down(quiet, knobs_);
    }
    if (quiet == before) {
      pass(clock);
    } else {
      pass(raster_.column_clock[column_]);
      step({false, true, false, 0, 0});
    }
  }
}

bool line_beam::offer(int clock, int len_m1, int value) {
  advance(clock);
  const interval_fifo_core::inputs in{false, consumes(), true, len_m1, value};
  if (!fifo_.ack(in, knobs_)) return false;
  step(in);
  return true;
}

int line_beam::starves_from() const {
  const int pixels = fifo_.pixels(knobs_);
  return pixels <= 0 ? now_ : column_end(column_ + pixels - 1);
}

// While full, only a used-up entry makes place.
int line_beam::offer_again() const {
  if (fifo_.tail_ptr_q != 0) return now_ + 1;
  return column_end(column_ + fifo_.tail_len_q);
}

}  // namespace racebeam
