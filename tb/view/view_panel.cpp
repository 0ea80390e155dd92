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
constexpr int LightsHeight = GlyphHeight + LightHeight + 14;

void paint_title(RgbImage& picture, int top, const Gauge& gauge) {
  picture.text(Left, top, gauge.title, Ink);
  const std::string value = std::to_string(gauge.now) + " of " + std::to_string(gauge.most);
  picture.text(Left + Width - GlyphWidth * static_cast<int>(value.size()), top, value,
               gauge.alarm ? Alarm : Now);
}

// How often each value 0..most was seen in the frame so far, on a root scale; the present one lit.
int paint_bars(RgbImage& picture, int top, int bar, const Gauge& gauge) {
  const auto& [title, seen, most, now, alarm] = gauge;
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

// One light for each of those that there are now.
int paint_lights(RgbImage& picture, int top, const Gauge& gauge) {
  const int step = Width / gauge.most;
  for (int i = 0; i < gauge.most; ++i)
    picture.fill(Left + i * step, top + GlyphHeight + BarGap, step - 2, LightHeight,
                 i < gauge.now ? Now : Rule);
  return top + LightsHeight;
}

// Of the bars, so that all below the statistics has room beside the chip's picture.
int bar_height(int top, const std::vector<Gauge>& gauges) {
  int others = 2 * GlyphHeight + 8, bars = 0;
  for (const Gauge& gauge : gauges) {
    bars += !gauge.seen.empty();
    others += gauge.seen.empty() ? LightsHeight : GlyphHeight + BarGap + GaugeGap;
  }
  return std::clamp((VisibleRows - top - others) / std::max(bars, 1), 12, 46);
}

}  // namespace

void paint_panel(RgbImage& picture, const FrameSource& source, const ViewState& state,
                 const std::string& statistics) {
  const int edge = source.watch().raster().columns, left = edge + Margin;
  picture.fill(edge, 0, PanelWidth, picture.height(), Paper);
  int top = 10;
  if (state.text) {
    picture.text(left, top, statistics, Ink);
    top += GlyphHeight * static_cast<int>(std::count(statistics.begin(), statistics.end(), '\n'));
    picture.fill(left, top + 4, Width, 1, Rule);
    top += 12;
  }
  const std::vector<Gauge> gauges = source.gauges();
  if (!state.gauges || gauges.empty()) return;
  const int bar = bar_height(top, gauges);
  for (const Gauge& gauge : gauges) {
    paint_title(picture, top, gauge);
    top = gauge.seen.empty() ? paint_lights(picture, top, gauge)
                             : paint_bars(picture, top, bar, gauge);
  }
  picture.text(Left, top, "bars: clocks of this frame\nlit: at the beam", Faint);
}

}  // namespace racebeam
