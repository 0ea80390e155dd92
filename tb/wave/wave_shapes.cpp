// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/wave_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

constexpr double Top = 0, Middle = LevelHeight / 2, Bottom = LevelHeight, Baseline = Middle + 4;

std::string point(double x, double y) { return svg_number(x) + " " + svg_number(y); }

double level(const WaveRun& run) { return run.value == "1" ? Top : Bottom; }

std::string hatched(const WaveRun& run) {
  return fmt::format("<rect class=\"unknown\" x=\"{}\" y=\"0\" width=\"{}\" height=\"{}\"/>\n",
                     svg_number(run.begin), svg_number(run.end - run.begin),
                     svg_number(LevelHeight));
}

double slope_of(const WaveRun& run) { return std::min(Slope, (run.end - run.begin) / 2); }

// Begins with the middle of its edge, at the window's begin with an upright one; open at its end.
std::string hexagon(const WaveRun& run, bool first, bool last) {
  const double slope = slope_of(run), left = first ? run.begin : run.begin + slope;
  const std::string end = svg_number(run.end);
  return "M" + end + " 0H" + svg_number(left) +
         (first ? "" : "L" + point(run.begin + slope / 2, Middle)) + "L" + point(left, Bottom) +
         "H" + end + (last ? "" : "L" + point(run.end + Slope / 2, Middle) + "Z");
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else out += c >= ' ' && c <= '~' ? c : '?';
  }
  return out;
}

std::string svg_number(double length) { return fmt::format("{}", std::round(length * 100) / 100); }

double text_width(const std::string& text) {
  return CharacterWidth * static_cast<double>(text.size());
}

std::string bit_shapes(const std::vector<WaveRun>& runs, bool is_clock) {
  std::string unknown, line, high;
  const WaveRun* before = nullptr;
  for (const WaveRun& run : runs) {
    if (run.value != "0" && run.value != "1") {
      unknown += hatched(run);
      before = nullptr;
      continue;
    }
    const double slope = is_clock || !before ? 0 : slope_of(run);
    line +=
        before ? "L" + point(run.begin + slope, level(run)) : "M" + point(run.begin, level(run));
    line += "H" + svg_number(run.end);
    if (run.value == "1") {
      const double after = is_clock || &run == &runs.back() ? 0 : Slope;
      high += "M" + point(run.begin, Bottom) + "L" + point(run.begin + slope, Top) + "H" +
              svg_number(run.end) + "L" + point(run.end + after, Bottom) + "Z";
    }
    before = &run;
  }
  if (!high.empty()) high = "<path class=\"fill\" d=\"" + high + "\"/>\n";
  if (!line.empty()) line = "<path class=\"level\" d=\"" + line + "\"/>\n";
  return high + unknown + line;
}

std::string bus_shapes(const std::vector<WaveRun>& runs) {
  std::string text;
  for (const WaveRun& run : runs) {
    if (run.value.empty()) {
      text += hatched(run);
      continue;
    }
    const bool first = &run == &runs.front(), last = &run == &runs.back();
    const double width = run.end - run.begin - (first ? 0 : Slope);
    const bool fits = text_width(run.value) + ValueMargin <= width;
    const std::string value = xml_text(run.value), shape = hexagon(run, first, last);
    text += fits ? "<path class=\"bus\" d=\"" + shape + "\"/>"
                 : "<path class=\"bus\" d=\"" + shape + "\"><title>" + value + "</title></path>";
    if (fits)
      text +=
          fmt::format("<text class=\"value\" x=\"{}\" y=\"{}\">{}</text>",
                      svg_number((run.begin + (first ? 0 : Slope) + run.end) / 2), Baseline, value);
    text += "\n";
  }
  return text;
}

}  // namespace racebeam
