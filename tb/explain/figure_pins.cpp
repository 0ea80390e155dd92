// A line as it leaves the pins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "sc/beam/tlm/chip_lines.h"
#include "tb/explain/figure_parts.h"

namespace racebeam {

namespace {

using Anchor = SvgSheet::Anchor;

constexpr double Left = 120, Width = 560, Top = 126, Pitch = 28, High = 14;

/// From bit 7 on, the order of the TinyVGA Pmod.
constexpr const char* Pins[] = {"hsync", "B0", "G0", "R0", "vsync", "B1", "G1", "R1"};

/// Calls `draw` with first and end of each run of equal values.
template <class Values, class Value, class Draw>
void each_run(const Values& values, const Value& value, const Draw& draw) {
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
    while (end < values.size() && value(values[end]) == value(values[begin])) ++end;
    draw(value(values[begin]), begin, end);
  }
}

}  // namespace

std::string draw_pins(const FigureSubject& subject) {
  chip_lines lines({subject.k, subject.show.program(), true, false, nullptr});
  lines.deposit(subject.frame);
  while (lines.next_line() != subject.y) lines.run_line();
  lines.run_line();
  const int clocks = lines.line_clocks(), marked = lines.column_clock(subject.pixel + 1);
  const auto x = [&](std::size_t clock) {
    return Left + Width * static_cast<double>(clock) / clocks;
  };
  SvgSheet sheet(740, Top + 8 * Pitch + 66, "A line at the pins");
  sheet.text({24, 26}, "A line as it leaves the pins", Anchor::Start, 16, Words, true);
  sheet.text({24, 48}, subject_text(subject), Anchor::Start, 12, Faint);
  sheet.text({Left - 12, 90}, "the screen", Anchor::End, 12, Words);
  const auto box = [&](std::size_t begin, std::size_t end, double top, double bottom,
                       const std::string& fill) {
    sheet.polygon({{x(begin), top}, {x(end), top}, {x(end), bottom}, {x(begin), bottom}}, fill,
                  None);
  };
  const auto colour = [](std::uint8_t c) { return int{c}; };
  each_run(lines.pixels(), colour, [&](int c, std::size_t begin, std::size_t end) {
    const auto clock = [&](std::size_t column) {
      const auto last = static_cast<std::size_t>(lines.column_clock(static_cast<int>(column)));
      return last + 1 - static_cast<std::size_t>(subject.k.clocks_per_pixel);
    };
    const std::size_t stop = end < VisibleColumns ? clock(end) : static_cast<std::size_t>(clocks);
    box(clock(begin), stop, 76, 104, svg_colour(c));
  });
  for (int row = 0; row < 8; ++row) {
    const int bit = 7 - row;
    const double base = Top + row * Pitch + High;
    sheet.text({Left - 12, base - High / 2}, fmt::format("uo[{}] {}", bit, Pins[row]), Anchor::End,
               12, Words);
    sheet.line({Left, base}, {Left + Width, base}, Faint, 1);
    const auto level = [bit](std::uint8_t pins) { return pins >> bit & 1; };
    each_run(lines.pins(), level, [&](int high, std::size_t begin, std::size_t end) {
      if (high) box(begin, end, base - High, base, Blue);
    });
    const int now = level(lines.pins()[static_cast<std::size_t>(marked)]);
    sheet.text({Left + Width + 12, base - High / 2}, std::to_string(now), Anchor::Start, 12, Taken,
               true);
  }
  const double bottom = Top + 8 * Pitch;
  sheet.line({x(static_cast<std::size_t>(marked)), 68},
             {x(static_cast<std::size_t>(marked)), bottom}, Taken, 1.5);
  sheet.text(
      {Left, bottom + 22},
      fmt::format("{} clocks of {:.1f} ns. The red line is the pixel; to its right, what the "
                  "pins are then.",
                  clocks, clock_period_ps(subject.k.clocks_per_pixel) / 1e3),
      Anchor::Start, 12, Faint);
  sheet.text({Left, bottom + 42},
             "Blue: high. Syncs are active low; bit 1 of a colour counts twice.", Anchor::Start, 12,
             Faint);
  return sheet.finish();
}

}  // namespace racebeam
