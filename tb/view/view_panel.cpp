// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tb/picture/pixel_font.h"
#include "tb/view/view_picture.h"

namespace racebeam {

namespace {

constexpr Rgb Paper{20, 21, 27}, Rule{52, 54, 64}, Ink{228, 228, 228}, Faint{140, 142, 152};
constexpr Rgb Bar{58, 110, 165}, Now{255, 196, 64}, Alarm{222, 45, 38};
constexpr int Margin = 12, Left = VisibleColumns + Margin, Width = PanelWidth - 2 * Margin;
constexpr int BarGap = 3, GaugeGap = 14, LightHeight = 10;
constexpr int DepthHeight = GlyphHeight + LightHeight + 14;

// How often each value 0..most was seen in the frame so far, on a root scale; the present one lit.
template <class Counts>
int paint_gauge(RgbImage& picture, int top, int bar, const std::string& title, const Counts& seen,
                int most, int now, bool alarm) {
  picture.text(Left, top, title, Ink);
  const std::string value = std::to_string(now) + " of " + std::to_string(most);
  picture.text(Left + Width - GlyphWidth * static_cast<int>(value.size()), top, value,
               alarm ? Alarm : Now);
  const int base = top + GlyphHeight + BarGap + bar;
  const int step = std::max(Width / (most + 1), 1);
  const std::uint64_t largest = std::max<std::uint64_t>(
      *std::max_element(seen.begin(), seen.begin() + std::min<int>(most + 1, seen.size())), 1);
  for (int i = 0; i <= most && i < static_cast<int>(seen.size()); ++i) {
    const double share = std::sqrt(static_cast<double>(seen[i]) / static_cast<double>(largest));
    const int height = seen[i] ? std::max(1, static_cast<int>(std::lround(share * bar))) : 0;
    const int width = std::max(step - 2, 1);
    picture.fill(Left + i * step, base - bar, width, bar, Rule);
    picture.fill(Left + i * step, base - height, width, height, i == now ? Now : Bar);
    picture.fill(Left + i * step, base + 2, width, 2, i == now ? (alarm ? Alarm : Now) : Paper);
  }
  return base + GaugeGap;
}

// The depth in which the tracer is: one light for each room.
int paint_depth(RgbImage& picture, int top, int depth, int most) {
  picture.text(Left, top, "rooms entered", Ink);
  const std::string value = std::to_string(depth) + " of " + std::to_string(most);
  picture.text(Left + Width - GlyphWidth * static_cast<int>(value.size()), top, value, Now);
  const int step = Width / most;
  for (int i = 0; i < most; ++i)
    picture.fill(Left + i * step, top + GlyphHeight + BarGap, step - 2, LightHeight,
                 i < depth ? Now : Rule);
  return top + DepthHeight;
}

// Of the bars, so that all below the statistics has room beside the chip's picture.
int bar_height(int top) {
  const int others = 2 * (GlyphHeight + BarGap + GaugeGap) + DepthHeight + 2 * GlyphHeight + 8;
  return std::clamp((VisibleRows - top - others) / 2, 12, 46);
}

}  // namespace

void paint_panel(RgbImage& picture, const FrameWatch& watch, const knobs& k, const ViewState& state,
                 const std::string& statistics) {
  const int edge = watch.raster().columns, left = edge + Margin;
  picture.fill(edge, 0, PanelWidth, picture.height(), Paper);
  int top = 10;
  if (state.text) {
    picture.text(left, top, statistics, Ink);
    top += GlyphHeight * static_cast<int>(std::count(statistics.begin(), statistics.end(), '\n'));
    picture.fill(left, top + 4, Width, 1, Rule);
    top += 12;
  }
  if (state.gauges) {
    const chip_view& now = watch.now();
    const frame_stats& stats = watch.stats();
    const int bar = bar_height(top);
    top = paint_gauge(picture, top, bar, "FIFO entries", stats.fifo_fill, k.fifo_entries, now.fill,
                      now.starving);
    top = paint_gauge(picture, top, bar, "interval stack", stats.stack_depth,
                      k.interval_stack_depth, now.sd, false);
    const int depth = now.tag >> LevelBits & ((1 << DepthBits) - 1);
    top = paint_depth(picture, top, depth, k.room_depth_limit());
    picture.text(Left, top, "bars: clocks of this frame\nlit: at the beam", Faint);
  }
}

}  // namespace racebeam
