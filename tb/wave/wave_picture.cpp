// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/wave_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "tb/wave/signal_look.h"
#include "tb/wave/wave_shapes.h"

namespace racebeam {

namespace {

constexpr double Margin = 14, LaneHeight = 25, HeadingHeight = 27, RulerHeight = 40, Gap = 12,
                 LegendHeight = 30, NumberMargin = 9, LeastNames = 80, NarrowestClock = 20,
                 WidestClock = 54, WideEnough = 2400;

constexpr const char* Style = R"(<style>
text{font-family:monospace;font-size:11px;fill:#24292f}
.name{text-anchor:end}
.heading,.place{font-weight:bold;font-size:12px}
.clock,.legend{fill:#57606a}
.clock,.value{text-anchor:middle}
.grid{stroke:#e4e7eb}
.strong{stroke:#b6bec8}
.level,.bus{stroke-width:1.3;stroke-linejoin:round}
.level{fill:none}
.unknown{fill:url(#unknown);stroke:#aab2bb}
.wire{stroke:#57606a}.wire .bus,.wire .fill{fill:#f1f3f5}
.input{stroke:#7a3ec8}.input .bus,.input .fill{fill:#f1e8fd}
.output{stroke:#c05a12}.output .bus,.output .fill{fill:#fdecdd}
.register{stroke:#22823c}.register .bus,.register .fill{fill:#e2f3e4}
.words{stroke:#9a7400}.words .bus{fill:#fdf5cf}
.lane text,.fill{stroke:none}
</style>
<defs><pattern id="unknown" width="6" height="6" patternUnits="userSpaceOnUse">
<path d="M0 6L6 0M-1 1L1 -1M5 7L7 5" stroke="#aab2bb"/></pattern></defs>
)";

constexpr const char* RoleClass[] = {"wire", "input", "output", "register", "words"};
constexpr const char* RoleLegend[] = {"wire", "input", "output", "register", "word"};

/// "u_stacks" of "chip.u_stacks".
std::string heading(const std::string& scope) {
  constexpr const char* Chip = "chip.";
  return scope.rfind(Chip, 0) == 0 ? scope.substr(std::string(Chip).size()) : scope;
}

class Drawing {
 public:
  explicit Drawing(const ClockedWaves& waves) : waves_(waves) {
    for (const auto& lane : waves.lanes)
      left_ = std::max({left_, text_width(lane.name), text_width(heading(lane.scope)) + 4});
    left_ += Margin + Gap;
    width_ = clock_width();
    right_ = x(waves.end);
    std::string scope;
    for (const auto& lane : waves_.lanes) {
      if (lane.scope != scope || body_.empty()) add_heading(scope = lane.scope);
      add_lane(lane);
    }
  }

  std::string text() const {
    const auto& first = waves_.clocks.front();
    const double width = right_ + Slope + Margin, height = bottom_ + LegendHeight;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
               "viewBox=\"0 0 {0} {1}\">\n<title>{2} clocks from {3}clock {4}</title>\n",
               svg_number(width), svg_number(height), waves_.clocks.size(),
               first.place.empty() ? "" : first.place + ", ", first.number) +
           Style + "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + ruler() + body_ +
           legend() + "</svg>\n";
  }

 private:
  double x(std::uint64_t time) const {
    const auto begin = waves_.clocks.front().time;
    const double clocks = static_cast<double>(waves_.clocks.size());
    return left_ + static_cast<double>(std::max(time, begin) - begin) /
                       static_cast<double>(waves_.end - begin) * clocks * width_;
  }

  std::vector<WaveRun> runs(const ClockedWaves::Lane& lane) const {
    const NumberFormat format = format_of(lane.name, lane.bits);
    std::vector<WaveRun> all{{left_, x(waves_.end), ""}};
    for (const auto& [time, digits] : lane.changes) {
      const double at = x(time);
      if (at >= all.back().end) break;
      const std::string value = formatted(digits, format, lane.bits);
      if (value == all.back().value) continue;
      if (at > all.back().begin) all.push_back({at, all.back().end, ""});
      if (all.size() > 1) all[all.size() - 2].end = at;
      all.back().value = value;
    }
    return all;
  }

  // As wide as the values need that stay for a few clocks only.
  double clock_width() {
    width_ = 1;
    double needed = std::max(NarrowestClock, widest_number() + NumberMargin + 1);
    for (const auto& lane : waves_.lanes)
      for (const WaveRun& run : runs(lane))
        if (lane.bits != 1)
          needed = std::max(needed,
                            (text_width(run.value) + Slope + ValueMargin) / (run.end - run.begin));
    const double room = WideEnough / static_cast<double>(waves_.clocks.size());
    return std::min(std::ceil(needed), std::clamp(room, NarrowestClock, WidestClock));
  }

  void add_heading(const std::string& scope) {
    bottom_ += HeadingHeight;
    body_ += fmt::format("<text class=\"heading\" x=\"{}\" y=\"{}\">{}</text>\n", Margin,
                         svg_number(bottom_ - 8), xml_text(heading(scope)));
  }

  void add_lane(const ClockedWaves::Lane& lane) {
    const auto role = static_cast<std::size_t>(role_of(lane.name, lane.bits));
    used_[role] = true;
    body_ += fmt::format(
        "<g class=\"lane {}\" data-signal=\"{}\" transform=\"translate(0 {})\">\n"
        "<text class=\"name\" x=\"{}\" y=\"12\">{}</text>\n{}</g>\n",
        RoleClass[role], xml_text(lane.path()), svg_number(bottom_), svg_number(left_ - Gap),
        xml_text(lane.name),
        lane.bits == 1 ? bit_shapes(runs(lane), lane.is_clock) : bus_shapes(runs(lane)));
    bottom_ += LaneHeight;
  }

  // Lines for the clocks, their numbers, and where frames and lines begin.
  std::string ruler() const {
    const double number = widest_number() + NumberMargin;
    const std::size_t every = number < width_ ? 1 : number < 2 * width_ ? 2 : 5;
    std::string lines, numbers;
    std::vector<std::pair<double, std::string>> places;
    for (std::size_t n = 0; n < waves_.clocks.size(); ++n) {
      const auto& clock = waves_.clocks[n];
      const double at = x(clock.time);
      const bool placed = places.empty() || clock.place != places.back().second;
      if (placed) places.emplace_back(at, clock.place);
      lines += fmt::format("<path class=\"grid{}\" d=\"M{} {}V{}\"/>\n", placed ? " strong" : "",
                           svg_number(at), placed ? Margin : RulerHeight, svg_number(bottom_));
      if (n % every == 0)
        numbers += fmt::format("<text class=\"clock\" x=\"{}\" y=\"36\">{}</text>\n",
                               svg_number(at + width_ / 2), xml_text(clock.number));
    }
    return lines +
           fmt::format("<text class=\"name legend\" x=\"{}\" y=\"36\">clock</text>\n",
                       svg_number(left_ - Gap)) +
           numbers + place_names(places);
  }

  // At the right of where it begins; if the next begins too soon, at the left of that.
  static std::string place_names(const std::vector<std::pair<double, std::string>>& places) {
    std::string text;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const auto& [at, place] = places[n];
      if (place.empty()) continue;
      const bool fits =
          n + 1 == places.size() || at + text_width(place) * 1.1 + Gap < places[n + 1].first;
      text += fmt::format("<text class=\"place\" x=\"{}\" y=\"20\"{}>{}</text>\n",
                          svg_number(fits ? at + Slope : places[n + 1].first - Slope),
                          fits ? "" : " text-anchor=\"end\"", xml_text(place));
    }
    return text;
  }

  double widest_number() const {
    double widest = 0;
    for (const auto& clock : waves_.clocks) widest = std::max(widest, text_width(clock.number));
    return widest;
  }

  // What the colours mean.
  std::string legend() const {
    std::string text;
    double at = left_;
    for (std::size_t role = 0; role < std::size(used_); ++role) {
      if (!used_[role]) continue;
      text += fmt::format(
          "<g class=\"{}\"><path class=\"bus\" d=\"M{} {}h14v9h-14z\"/></g>"
          "<text class=\"legend\" x=\"{}\" y=\"{}\">{}</text>\n",
          RoleClass[role], svg_number(at), svg_number(bottom_ + 10), svg_number(at + 19),
          svg_number(bottom_ + 18.5), RoleLegend[role]);
      at += 19 + text_width(RoleLegend[role]) + 2 * Gap;
    }
    return text;
  }

  const ClockedWaves& waves_;
  double left_ = LeastNames, right_ = 0, bottom_ = RulerHeight;
  double width_ = 1;  // of a clock
  std::string body_;
  bool used_[std::size(RoleClass)] = {};
};

}  // namespace

std::string wave_picture(const ClockedWaves& waves) { return Drawing(waves).text(); }

}  // namespace racebeam
