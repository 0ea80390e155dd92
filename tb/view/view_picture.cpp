// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_picture.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "tb/picture/pixel_font.h"
#include "tb/view/map_picture.h"
#include "tb/view/view_panel.h"

namespace racebeam {

namespace {

constexpr Rgb Beam{255, 64, 220}, Border{64, 255, 160}, Shade{10, 10, 14}, Ink{235, 235, 235};
constexpr Rgb KeyInk{255, 212, 96}, Alarm{150, 20, 20};

// The last pixel of each interval. Without a known one, a line has none.
void paint_borders(RgbImage& picture, const std::vector<IntervalEvent>& intervals) {
  for (const IntervalEvent& event : intervals)
    if (event.known() && event.to < LastPixel)
      picture.dot(event.to + 1, event.y - FirstVisibleLine, Border);
}

// Its line, faint, and the beam itself; nothing in the blanked lines.
void paint_beam(RgbImage& picture, const FrameWatch& watch) {
  const BeamScreen& screen = watch.screen();
  const Raster& raster = watch.raster();
  const int row = screen.y() - raster.first_visible_line;
  if (watch.whole() || row < 0 || row >= raster.rows) return;
  const int column = watch.raster().column_at[screen.clock_of_line()];
  picture.tint(0, row, raster.columns, 1, Beam, 0.6);
  picture.fill(column - 1, row - 5, 3, 11, Beam);
  picture.fill(column - 5, row - 1, 11, 3, Beam);
}

void paint_help(RgbImage& picture, const std::vector<KeyHelp>& rows) {
  constexpr int Left = 110, Margin = 14, KeyLetters = 12, RowHeight = 15;
  const int height = 2 * Margin + RowHeight * static_cast<int>(rows.size());
  const int top = (VisibleRows - height) / 2;
  picture.tint(Left, top, VisibleColumns - 2 * Left, height, Shade, 0.88);
  int y = top + Margin;
  for (const KeyHelp& row : rows) {
    picture.text(Left + Margin, y, row.keys, KeyInk);
    picture.text(Left + Margin + GlyphWidth * KeyLetters, y, row.meaning, Ink);
    y += RowHeight;
  }
}

constexpr int TextMargin = 8;

// Breaks lines that are longer than the picture is wide.
std::vector<std::string> broken(const std::string& text) {
  constexpr std::size_t Letters = (VisibleColumns - 2 * TextMargin) / GlyphWidth, MostLines = 12;
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line) && lines.size() < MostLines;)
    for (; !line.empty(); line.erase(0, Letters)) lines.push_back(line.substr(0, Letters));
  return lines;
}

void paint_lines(RgbImage& picture, int top, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    picture.text(TextMargin, top, line, Ink);
    top += GlyphHeight;
  }
}

int height_of(const std::vector<std::string>& lines, int margin) {
  return 2 * margin + GlyphHeight * static_cast<int>(lines.size());
}

void paint_error(RgbImage& picture, const std::string& error) {
  const std::vector<std::string> lines = broken(error);
  picture.fill(0, 0, VisibleColumns, height_of(lines, TextMargin), Alarm);
  paint_lines(picture, TextMargin, lines);
}

}  // namespace

void paint_message(RgbImage& picture, const std::string& message, const FrameWatch& watch) {
  constexpr int Margin = 3;
  const std::vector<std::string> lines = broken(message);
  const int height = height_of(lines, Margin);
  const Raster& raster = watch.raster();
  const int row = watch.screen().y() - raster.first_visible_line;
  const int top = !watch.whole() && row > raster.rows / 2 ? 0 : raster.rows - height;
  picture.tint(0, top, raster.columns, height, Shade, 0.8);
  paint_lines(picture, top + Margin, lines);
}

RgbImage view_picture(const FrameSource& source, const ViewState& state, const ViewWords& words) {
  const FrameWatch& watch = source.watch();
  const bool panel = state.gauges || state.text;
  const int columns = watch.raster().columns, rows = watch.raster().rows;
  RgbImage picture(watch.screen().colours(), columns, rows, columns + (panel ? PanelWidth : 0),
                   rows + (state.map ? MapBarHeight : 0));
  if (const PackedPicture* const deep = source.picture())
    for (int y = 0; y < deep->height; ++y)
      for (int x = 0; x < deep->width; ++x)
        picture.dot(
            x, y, rgb_of(deep->colour(static_cast<std::size_t>(y) * deep->width + x), deep->bits));
  if (state.map) {
    paint_map(picture, make_map(*state.map, source.intervals(), watch.raster()), !watch.whole());
    paint_bar(picture, VisibleRows, *state.map, words.where);
  }
  if (state.borders) paint_borders(picture, source.intervals());
  if (state.beam) paint_beam(picture, watch);
  if (panel) paint_panel(picture, source, state, words.statistics);
  if (state.help) paint_help(picture, ViewControl::help(ViewControl::chip_of(state)));
  if (!words.error.empty()) paint_error(picture, words.error);
  return picture;
}

}  // namespace racebeam
