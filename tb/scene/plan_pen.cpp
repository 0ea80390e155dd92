// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_pen.h"

#include <cairo-svg.h>

#include <cmath>
#include <stdexcept>

namespace racebeam {

namespace {

constexpr double Ground = 0.6;  // how white it is behind letters

cairo_status_t append(void* to, const unsigned char* data, unsigned size) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("the plan cannot be drawn: ") +
                             cairo_status_to_string(status));
}

}  // namespace

bool Box::meets(const Box& o) const {
  return left < o.left + o.width && o.left < left + width && top < o.top + o.height &&
         o.top < top + height;
}

PlanPen::PlanPen(PlanFormat format, int width, int height)
    : format_(format),
      surface_(format == PlanFormat::Svg
                   ? cairo_svg_surface_create_for_stream(append, &bytes_, width, height)
                   : cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      sheet_(cairo_create(surface_.get())) {
  if (format == PlanFormat::Svg)
    cairo_svg_surface_set_document_unit(surface_.get(), CAIRO_SVG_UNIT_PX);
  cairo_set_line_join(sheet_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(sheet_.get(), CAIRO_LINE_CAP_ROUND);
  fill({0, 0, static_cast<double>(width), static_cast<double>(height)}, {1, 1, 1});
}

void PlanPen::ink(Ink ink) { cairo_set_source_rgb(sheet_.get(), ink.r, ink.g, ink.b); }

void PlanPen::fill(const Box& box, Ink colour) {
  ink(colour);
  cairo_rectangle(sheet_.get(), box.left, box.top, box.width, box.height);
  cairo_fill(sheet_.get());
}

void PlanPen::frame(const Box& box, Ink colour, double thick, bool dashed) {
  constexpr double Dash = 4;
  ink(colour);
  cairo_set_line_width(sheet_.get(), thick);
  cairo_set_dash(sheet_.get(), &Dash, dashed ? 1 : 0, 0);
  cairo_rectangle(sheet_.get(), box.left, box.top, box.width, box.height);
  cairo_stroke(sheet_.get());
  cairo_set_dash(sheet_.get(), nullptr, 0, 0);
}

void PlanPen::line(const std::vector<Dot>& dots, Ink colour, double thick) {
  ink(colour);
  cairo_set_line_width(sheet_.get(), thick);
  for (const Dot& dot : dots) cairo_line_to(sheet_.get(), dot.x, dot.y);
  if (dots.size() == 1) cairo_close_path(sheet_.get());
  cairo_stroke(sheet_.get());
}

void PlanPen::circle(Dot middle, double radius, Ink inside, Ink edge) {
  cairo_new_sub_path(sheet_.get());
  cairo_arc(sheet_.get(), middle.x, middle.y, radius, 0, 2 * M_PI);
  ink(inside);
  cairo_fill_preserve(sheet_.get());
  ink(edge);
  cairo_set_line_width(sheet_.get(), 1.3);
  cairo_stroke(sheet_.get());
}

void PlanPen::triangle(Dot middle, double width, double height, Ink colour) {
  ink(colour);
  cairo_move_to(sheet_.get(), middle.x, middle.y - height / 2);
  cairo_line_to(sheet_.get(), middle.x + width / 2, middle.y + height / 2);
  cairo_line_to(sheet_.get(), middle.x - width / 2, middle.y + height / 2);
  cairo_close_path(sheet_.get());
  cairo_fill(sheet_.get());
}

void PlanPen::font(double letters, bool bold) {
  cairo_select_font_face(sheet_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(sheet_.get(), letters);
}

Dot PlanPen::size(const std::string& text, double letters, bool bold) {
  font(letters, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(sheet_.get(), text.c_str(), &extents);
  return {extents.x_advance, letters};
}

void PlanPen::text(Dot middle, const std::string& text, double letters, Ink colour, bool bold,
                   bool turned) {
  constexpr double Capital = 0.72;  // height of a capital letter
  const double width = size(text, letters, bold).x;
  cairo_save(sheet_.get());
  cairo_translate(sheet_.get(), middle.x, middle.y);
  if (turned) cairo_rotate(sheet_.get(), -M_PI / 2);
  cairo_set_source_rgba(sheet_.get(), 1, 1, 1, Ground);
  cairo_rectangle(sheet_.get(), -width / 2, -letters / 2, width, letters);
  cairo_fill(sheet_.get());
  ink(colour);
  cairo_move_to(sheet_.get(), -width / 2, letters * Capital / 2);
  cairo_show_text(sheet_.get(), text.c_str());
  cairo_restore(sheet_.get());
}

std::string PlanPen::finish() {
  check(cairo_status(sheet_.get()));
  if (format_ == PlanFormat::Png)
    check(cairo_surface_write_to_png_stream(surface_.get(), append, &bytes_));
  cairo_surface_finish(surface_.get());
  check(cairo_surface_status(surface_.get()));
  return bytes_;
}

}  // namespace racebeam
