// WaveShapes: the shapes of a lane in a drawing of a waveform, as SVG. Lengths are pixels.
//
// A change at x has sloped edges that begin at x; the shapes of a lane have their top at y 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// Sizes of what is drawn. Widths of text are those of the widest usual monospaced fonts.
constexpr double LevelHeight = 16, Slope = 4, CharacterWidth = 6.65, ValueMargin = 5;

/// For as long as a lane keeps its value.
struct WaveRun {
  double begin, end;
  std::string value;  ///< as it is shown; empty: unknown
};

/// Text with what XML reserves replaced.
std::string xml_text(const std::string& text);
/// A length in at most two decimals, "12.5".
std::string svg_number(double length);

double text_width(const std::string& text);

/// A square wave or a level that follows runs of "0" and "1".
std::string bit_shapes(const std::vector<WaveRun>& runs, bool is_clock);
/// A hexagon for each run.
std::string bus_shapes(const std::vector<WaveRun>& runs);

}  // namespace racebeam
