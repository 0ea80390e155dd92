// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_inputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sc/base/constants.h"
#include "tb/base/csv_file.h"
#include "tb/base/errors.h"

namespace racebeam {

namespace {

enum Column { Frame, Line, Clock, Ui, Uio };
const std::vector<std::string> Columns = {"frame", "line", "clock", "ui", "uio"};
constexpr const char* Reset = "reset";
// Whether a frame has such a line and clock is known when the frames are.
constexpr int MostFrames = 1'000'000, MostLines = 10'000, MostClocks = 1'000'000;

}  // namespace

TtInputs TtInputs::read(const std::string& path, TilePins start) {
  TtInputs inputs(start);
  inputs.file_ = path;
  CsvFile csv(path, Columns);
  bool first = true;
  while (csv.next()) {
    const auto pins = [&](Column column) {
      return static_cast<std::uint8_t>(csv.number(column, 0, 255));
    };
    if (csv.text(Frame) == Reset) {
      csv.number(Line, 0, 0);
      csv.number(Clock, 0, 0);
      if (!first) csv.fail(Frame, "is reset, which only the first row may be");
      inputs.start_ = {pins(Ui), pins(Uio)};
      first = false;
      continue;
    }
    first = false;
    const auto number = [&](Column column, int min, int max) {
      return static_cast<int>(csv.number(column, min, max));
    };
    const TileInput input{number(Frame, 0, MostFrames - 1),
                          number(Line, -MostLines, MostLines),
                          number(Clock, 0, MostClocks),
                          {pins(Ui), pins(Uio)},
                          csv.line()};
    if (!inputs.changes_.empty() && input.place() <= inputs.changes_.back().place())
      csv.fail(Frame,
               "and line and clock are not behind those of the row before; rows stand in the "
               "order of time");
    inputs.changes_.push_back(input);
  }
  return inputs;
}

std::vector<std::uint64_t> TtInputs::clocks(const Raster& raster) const {
  std::vector<std::uint64_t> all;
  for (const TileInput& input : changes_) {
    const auto check = [&](const char* what, int value, int min, int max) {
      if (value < min || value > max)
        throw UsageError(fmt::format("{}:{}: {} is {}; the frames of this chip have {}..{}", file_,
                                     input.row, what, value, min, max));
    };
    check("line", input.line, raster.first_line, raster.last_line());
    check("clock", input.clock, 0, raster.line_clocks() - 1);
    all.push_back(static_cast<std::uint64_t>(input.frame) * raster.frame_clocks() +
                  static_cast<std::uint64_t>(input.line - raster.first_line) *
                      raster.line_clocks() +
                  input.clock);
  }
  return all;
}

void TtInputs::change(const TileInput& input) {
  while (!changes_.empty() && changes_.back().place() >= input.place()) changes_.pop_back();
  changes_.push_back(input);
}

std::string TtInputs::text() const {
  std::string text =
      fmt::format("{}\n{},0,0,{},{}\n", fmt::join(Columns, ","), Reset, start_.ui, start_.uio);
  for (const TileInput& in : changes_)
    text += fmt::format("{},{},{},{},{}\n", in.frame, in.line, in.clock, in.pins.ui, in.pins.uio);
  return text;
}

}  // namespace racebeam
