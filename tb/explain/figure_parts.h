// How each of the figures is drawn, and the colours that they share.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/explain/figures.h"
#include "tb/explain/ray_walk.h"
#include "tb/explain/svg_sheet.h"

namespace racebeam {

constexpr const char *Words = "#1a1c20", *Faint = "#8a8f98", *Line = "#40454d", *Pale = "#edf1f6",
                     *Blue = "#bcd0e8", *Taken = "#d6331f", *TakenPale = "#fbe3df",
                     *Green = "#219e54", *GreenPale = "#dcf2e4", *None = "none";

std::string draw_hexagon(const FigureSubject& subject);
std::string draw_portal(const FigureSubject& subject);
std::string draw_tree(const FigureSubject& subject);
std::string draw_pyramid(const FigureSubject& subject);
std::string draw_steps(const FigureSubject& subject);
std::string draw_pins(const FigureSubject& subject);
std::string draw_platform(const FigureSubject& subject);

/// "pixel 319 of line 0, frame 1000 of demo".
std::string subject_text(const FigureSubject& subject);

/// A title at `top` and, below it, what the figure is of.
void draw_legend(SvgSheet& sheet, double top, const std::string& title,
                 const FigureSubject& subject, const RayWalk& walk);

/// A colour of the chip, r * 16 + g * 4 + b, as SVG has it.
std::string svg_colour(int colour);

SvgPoint middle(const std::vector<SvgPoint>& points);

/// Axis of the face that the answer to level 7 chose.
int chosen_face(const TracerStep& exit);

}  // namespace racebeam
