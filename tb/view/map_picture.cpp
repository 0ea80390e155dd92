// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/map_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tb/picture/pixel_font.h"

namespace racebeam {

namespace {

constexpr Rgb Starved{222, 45, 38}, Unknown{96, 96, 96};
constexpr Rgb Paper{18, 18, 22}, Ink{225, 225, 225}, Faint{150, 150, 155};
constexpr float DeepestColour = 8;

/// A scale from its first colour to its last, evenly.
using Colours = std::vector<Rgb>;

const Colours& colours_of(MapKind kind) {
  static const Colours slack{{255, 226, 120}, {178, 221, 142}, {72, 176, 158},
                             {38, 125, 168},  {36, 72, 140},   {22, 32, 82}};
  static const Colours cost{{0, 0, 4},     {51, 16, 104},  {136, 34, 106},
                            {212, 72, 66}, {250, 142, 36}, {252, 255, 200}};
  static const Colours depth{{68, 1, 84},    {65, 68, 135},  {42, 120, 142},
                             {34, 168, 132}, {122, 209, 81}, {253, 231, 37}};
  return kind == MapKind::Slack ? slack : kind == MapKind::Cost ? cost : depth;
}

Rgb on_scale(const Colours& colours, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const auto from = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  return mix(colours[from], colours[from + 1], place - static_cast<double>(from));
}

/// Octaves of the logarithmic scales.
struct Octaves {
  double first, count;
};
Octaves octaves_of(MapKind kind) {
  return kind == MapKind::Slack ? Octaves{0, 10} : Octaves{-5, 9};
}

double share_of(MapKind kind, double value) {
  if (kind == MapKind::Depth) return value / DeepestColour;
  const Octaves octaves = octaves_of(kind);
  return value <= 0 ? 0 : (std::log2(value) - octaves.first) / octaves.count;
}

struct Tick {
  double value;
  const char* text;
};
std::vector<Tick> ticks_of(MapKind kind) {
  if (kind == MapKind::Slack)
    return {{1, "1"}, {4, "4"}, {16, "16"}, {64, "64"}, {256, "256"}, {1024, "1024 clocks"}};
  if (kind == MapKind::Cost)
    return {{1 / 32.0, "1/32"}, {1 / 8.0, "1/8"}, {1 / 2.0, "1/2"}, {2, "2"}, {8, "8"}, {16, "16"}};
  return {{0, "0"}, {2, "2"}, {4, "4"}, {6, "6"}, {8, "8 rooms"}};
}

const char* title_of(MapKind kind) {
  return kind == MapKind::Slack  ? "slack: clocks between known and shown"
         : kind == MapKind::Cost ? "cost: decisions per pixel"
                                 : "depth: rooms entered";
}

// map_colour of whole clocks, of which there are not more than a line has.
Rgb slack_colour(float clocks) {
  constexpr int LongestLine = 8 * LinePixels;
  static const Colours table = [] {
    Colours colours;
    for (int i = 0; i <= LongestLine; ++i)
      colours.push_back(map_colour(MapKind::Slack, static_cast<float>(i)));
    return colours;
  }();
  return table[std::clamp(static_cast<int>(clocks), 0, LongestLine)];
}

}  // namespace

Rgb map_colour(MapKind kind, float value) {
  if (value == FrameMap::Unknown) return kind == MapKind::Slack ? Starved : Unknown;
  if (kind == MapKind::Slack && value <= 0) return Starved;
  return on_scale(colours_of(kind), share_of(kind, value));
}

void paint_map(RgbImage& picture, const FrameMap& map, bool running) {
  float last = FrameMap::Unknown;  // neighbours often have the same value
  Rgb colour = map_colour(map.kind, last);
  for (int row = 0; row < VisibleRows; ++row)
    for (int column = 0; column < VisibleColumns; ++column) {
      const float value = map.at(column, row);
      if (value == FrameMap::Unknown && running) continue;
      if (value != last) {
        last = value;
        colour = map.kind == MapKind::Slack ? slack_colour(value) : map_colour(map.kind, value);
      }
      picture.dot(column, row, colour);
    }
}

void paint_bar(RgbImage& picture, int top, MapKind kind, const std::string& where) {
  constexpr int Left = 86, Width = VisibleColumns - Left - 90, Height = 12, TickHeight = 3;
  const int bar_top = top + 16, words_top = bar_top + Height + TickHeight;
  picture.fill(0, top, VisibleColumns, MapBarHeight, Paper);
  picture.text(Left, top + 2, title_of(kind), Ink);
  picture.text(VisibleColumns - 8 - GlyphWidth * static_cast<int>(where.size()), top + 2, where,
               Faint);
  for (int x = 0; x < Width; ++x)
    picture.fill(Left + x, bar_top, 1, Height,
                 on_scale(colours_of(kind), static_cast<double>(x) / (Width - 1)));
  for (const Tick& tick : ticks_of(kind)) {
    const int x = Left + static_cast<int>(std::lround(share_of(kind, tick.value) * (Width - 1)));
    picture.fill(x, bar_top + Height, 1, TickHeight, Ink);
    const std::string words = tick.text;  // the number stands below its tick, a unit after it
    const auto digits = static_cast<int>(std::min(words.find(' '), words.size()));
    picture.text(x - GlyphWidth * digits / 2, words_top, words, Ink);
  }
  constexpr int BlockLeft = 16, BlockWidth = 50;
  const bool slack = kind == MapKind::Slack;
  picture.fill(BlockLeft, bar_top, BlockWidth, Height, slack ? Starved : Unknown);
  picture.text(BlockLeft + (slack ? 4 : 1), words_top, slack ? "starved" : "unknown", Ink);
}

RgbImage map_picture(const FrameMap& map, const std::string& where) {
  RgbImage picture(VisibleColumns, VisibleRows + MapBarHeight, Paper);
  paint_map(picture, map);
  paint_bar(picture, VisibleRows, map.kind, where);
  return picture;
}

}  // namespace racebeam
