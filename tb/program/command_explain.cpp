// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_explain.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/explain/explain_json.h"
#include "tb/explain/explain_text.h"
#include "tb/show/open_show.h"
#include "tb/show/set_knob.h"

namespace racebeam {

namespace {

struct Pixel {
  int column, row;
};

std::optional<int> whole_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Pixel pixel_of(const std::string& text) {
  const auto comma = text.find(',');
  std::optional<int> column, row;
  if (comma != std::string::npos) {
    column = whole_number(text.substr(0, comma));
    row = whole_number(text.substr(comma + 1));
  }
  if (!column || !row)
    throw UsageError(
        fmt::format("--pixel '{}' is not of the form X,Y, as in --pixel 320,240", text));
  if (*column < 0 || *column >= VisibleColumns || *row < 0 || *row >= VisibleRows)
    throw UsageError(fmt::format("--pixel {},{} is outside the picture; X is 0..{}, Y is 0..{}",
                                 *column, *row, VisibleColumns - 1, VisibleRows - 1));
  return {*column, *row};
}

}  // namespace

int command_explain(const ExplainOptions& options) {
  const Pixel pixel = pixel_of(options.pixel);
  const Show show = open_show(options.scene);
  if (options.frame < 0 || options.frame >= show.frames())
    throw UsageError(
        fmt::format("--frame {} is out of range; 0..{}", options.frame, show.frames() - 1));
  knobs k = show.standard_knobs();
  set_knobs(k, options.assignments);
  std::string repeat = options.scene;
  for (const std::string& assignment : options.assignments) repeat += " --set " + assignment;
  if (const std::string why = show.objection(k); !why.empty()) throw UsageError(why);
  const Explanation e(show, k, static_cast<int>(options.frame), pixel.column, pixel.row);
  print(options.json ? explain_json(e, k, repeat) : explain_text(e, repeat));
  return ExitGood;
}

}  // namespace racebeam
