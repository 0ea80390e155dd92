// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/svg_sheet.h"

#include <fmt/format.h>

#include <cmath>

namespace racebeam {

namespace {

/// Tenths of a pixel, never "-0".
std::string length(double value) {
  const long tenths = std::lround(value * 10);
  return tenths % 10 ? fmt::format("{}{}.{}", tenths < 0 ? "-" : "", std::labs(tenths) / 10,
                                   std::labs(tenths) % 10)
                     : fmt::format("{}", tenths / 10);
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text)
    safe += letter == '&'   ? "&amp;"
            : letter == '<' ? "&lt;"
            : letter == '>' ? "&gt;"
                            : std::string(1, letter);
  return safe;
}

}  // namespace

SvgSheet::SvgSheet(double width, double height, const std::string& title)
    : body_(
          fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                      "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, sans-serif\">\n"
                      "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                      length(width), length(height), escaped(title))) {}

void SvgSheet::polygon(const std::vector<SvgPoint>& points, const std::string& fill,
                       const std::string& stroke, double thick) {
  body_ += "<polygon points=\"";
  for (std::size_t i = 0; i < points.size(); ++i)
    body_ += fmt::format("{}{},{}", i ? " " : "", length(points[i].x), length(points[i].y));
  body_ += fmt::format("\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", fill, stroke,
                       length(thick));
}

void SvgSheet::line(SvgPoint from, SvgPoint to, const std::string& stroke, double thick,
                    bool dashed) {
  body_ += fmt::format(
      "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
      length(from.x), length(from.y), length(to.x), length(to.y), stroke, length(thick),
      dashed ? " stroke-dasharray=\"5 4\"" : "");
}

void SvgSheet::circle(SvgPoint middle, double radius, const std::string& fill) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", length(middle.x),
                       length(middle.y), length(radius), fill);
}

void SvgSheet::text(SvgPoint at, const std::string& text, Anchor anchor, double letters,
                    const std::string& fill, bool bold) {
  constexpr double HalfOfACapital = 0.36;
  constexpr const char* anchors[] = {"start", "middle", "end"};
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n",
      length(at.x), length(at.y + HalfOfACapital * letters), anchors[static_cast<int>(anchor)],
      length(letters), fill, bold ? " font-weight=\"bold\"" : "", escaped(text));
}

std::string SvgSheet::finish() { return body_ + "</svg>\n"; }

}  // namespace racebeam
