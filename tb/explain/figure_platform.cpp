// The chip in a virtual platform: what goes over its two sockets.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "sc/beam/tlm/chip_lines.h"
#include "sc/beam/tlm/tlm_map.h"
#include "tb/explain/figure_parts.h"

namespace racebeam {

namespace {

using Anchor = SvgSheet::Anchor;

constexpr int Columns = 40, Rows = 30;  // of the picture in the memory, 16 x 16 pixels each

struct Box {
  double left, top, width, height;
  SvgPoint middle() const { return {left + width / 2, top + height / 2}; }
  std::vector<SvgPoint> corners() const {
    return {{left, top}, {left + width, top}, {left + width, top + height}, {left, top + height}};
  }
};

void arrow(SvgSheet& sheet, SvgPoint from, SvgPoint to) {
  sheet.line(from, {to.x - 8, to.y}, Line, 2);
  sheet.polygon({to, {to.x - 10, to.y - 5}, {to.x - 10, to.y + 5}}, Line, None);
}

std::string hex(std::uint64_t address) { return fmt::format("0x{:03x}", address); }

}  // namespace

std::string draw_platform(const FigureSubject& subject) {
  chip_lines lines({subject.k, subject.show.program(), false, false, nullptr});
  lines.deposit(subject.frame);
  SvgSheet sheet(760, 400, "The chip in a virtual platform");
  sheet.text({24, 26}, "The chip in a virtual platform", Anchor::Start, 16, Words, true);
  sheet.text({24, 48},
             fmt::format("line {}, frame {} of {}", subject.y, subject.frame, subject.show.name()),
             Anchor::Start, 12, Faint);
  const Box host{24, 90, 150, 120}, chip{260, 90, 150, 120}, memory{500, 90, 240, 180};
  for (const Box& box : {host, chip}) sheet.polygon(box.corners(), Pale, Line, 1.5);
  sheet.text(host.middle(), "your CPU model", Anchor::Middle, 13, Words, true);
  sheet.text({chip.middle().x, chip.middle().y - 10}, "tlm_chip", Anchor::Middle, 13, Words, true);
  sheet.text({chip.middle().x, chip.middle().y + 10}, "loosely timed", Anchor::Middle, 12, Faint);
  arrow(sheet, {host.left + host.width, 150}, {chip.left, 150});
  sheet.text({217, 136}, "register_socket", Anchor::Middle, 10, Words);
  arrow(sheet, {chip.left + chip.width, 150}, {memory.left, 150});
  sheet.text({455, 136}, "display_socket", Anchor::Middle, 10, Words);

  // What the memory holds when the frame is whole, coarsely: the middle of each square.
  const double step = memory.width / Columns;
  for (int row = 0; row < Rows; ++row) {
    while (lines.y() != FirstVisibleLine + row * 16 + 8 || !lines.visible()) lines.run_line();
    const auto& pixels = lines.pixels();
    const auto at = [&](int column) { return pixels[static_cast<std::size_t>(column) * 16 + 8]; };
    for (int begin = 0, end = 0; begin < Columns; begin = end) {
      while (end < Columns && at(end) == at(begin)) ++end;
      sheet.polygon(
          Box{memory.left + begin * step, memory.top + row * step, (end - begin) * step, step + 0.5}
              .corners(),  // no seam to the next row

          svg_colour(at(begin)), None);
    }
  }
  sheet.polygon(memory.corners(), None, Line, 1.5);
  const int shown = subject.y - FirstVisibleLine;
  const double y = memory.top + memory.height * (shown + 0.5) / VisibleRows;
  sheet.line({memory.left - 6, y}, {memory.left + memory.width + 6, y}, Taken, 2);

  double down = 240;
  const auto reads = [&](std::uint64_t address, const std::string& what) {
    sheet.text({24, down}, hex(address), Anchor::Start, 12, Words, true);
    sheet.text({84, down}, what, Anchor::Start, 12, Words);
    down += 20;
  };
  reads(RegisterFrame, fmt::format("the frame: {}", subject.frame));
  reads(RegisterLine, "the next line");
  reads(RegisterFrames, "frames since the start");
  reads(RegisterReset, "write 1: the chip starts anew");
  reads(RegisterKnobs, fmt::format("its {} knobs", knob_table().size()));
  reads(RegisterCounters, fmt::format("{} counters of the last frame", counter_registers().size()));
  const auto row = static_cast<std::uint64_t>(shown);
  sheet.text({500, 294},
             fmt::format("{}  this line, {} bytes, one a pixel", hex(VisibleColumns * row),
                         VisibleColumns),
             Anchor::Start, 12, Taken);
  sheet.text({500, 314}, fmt::format("{}  the frame's number, 4 bytes", hex(DisplayFrame)),
             Anchor::Start, 12, Words);
  sheet.text({24, 382},
             fmt::format("A line is one transaction, annotated with its end: {:.2f} us after its "
                         "beginning.",
                         lines.line_clocks() * clock_period_ps(subject.k.clocks_per_pixel) / 1e6),
             Anchor::Start, 12, Faint);
  return sheet.finish();
}

}  // namespace racebeam
