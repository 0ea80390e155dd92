// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/core_renderer.h"

#include "sc/chip_core.h"
#include "tb/raster.h"
#include "tb/vga_monitor.h"

namespace racebeam {

GoldenPicture core_picture(int frame, const knobs& k, const scene_program* program) {
  chip_core chip(program);
  chip.clock(false, k);
  chip.deposit(frame, k);

  const Raster raster(k.clocks_per_pixel, k.speed);
  GoldenPicture picture;
  picture.reserve(VisibleColumns * VisibleRows);
  for (int y = FirstLine; y < FirstVisibleLine + VisibleRows; ++y)
    for (int clock = 0; clock < raster.line_clocks(); ++clock) {
      const int uo = chip.clock(true, k).uo;
      if (raster.visible_line(y) && clock >= raster.active_begin && raster.clocks[clock].last)
        picture.push_back(static_cast<std::uint8_t>(colour_of_pins(uo)));
    }
  return picture;
}

}  // namespace racebeam
