// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_rows.h"

#include <algorithm>

namespace racebeam {

namespace {

// Where row `index` of the text at `node` stands, if the file shows it as it is.
Place row_place(const TomlNode& node, int index, std::string_view row,
                const std::vector<std::string_view>& file) {
  const std::size_t line = node.place.line - 1, column = node.place.column - 1;
  if (line >= file.size() || column > file[line].size()) return node.place;
  const std::string_view text = file[line].substr(column);
  const std::string_view quotes = text.substr(0, 3);
  const std::size_t opening = quotes == "\"\"\"" || quotes == "'''" ? 3 : 1;
  const bool starts_here = text.size() > opening;
  if (starts_here && index == 0 && text.substr(opening, row.size()) == row)
    return {node.place.line, node.place.column + static_cast<int>(opening)};
  const std::size_t at = line + index + (starts_here ? 0 : 1);
  if (at > line && at < file.size() && file[at].substr(0, row.size()) == row)
    return {static_cast<int>(at) + 1, 1};
  return node.place;
}

bool read_storey(const TomlNode& node, const std::vector<std::string_view>& file, PlanRows& to,
                 Faults& faults) {
  if (node.kind != TomlNode::String) {
    faults.add(node.place, std::string("a storey is ") + node.kind_name(),
               "draw it between \"\"\" and \"\"\", a row in each line");
    return false;
  }
  const std::vector<std::string_view> lines = split_lines(node.text);
  std::vector<PlanRow> rows;
  bool good = true;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    PlanRow row{letters(lines[i]), row_place(node, static_cast<int>(i), lines[i], file)};
    if (!rows.empty() && row.cells.size() != rows[0].cells.size()) {
      faults.add(row.place,
                 "this row has " + std::to_string(row.cells.size()) + " cells, the first one " +
                     std::to_string(rows[0].cells.size()),
                 "make all rows equally long; '#' is solid");
      good = false;
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty() || rows[0].cells.empty()) {
    faults.add(node.place, "the plan is empty", "draw at least one open cell: '.' or '@'");
    return false;
  }
  to.storeys.push_back(std::move(rows));
  return good;
}

}  // namespace

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    at = end + 1;
  }
  return lines;
}

std::vector<Letter> letters(std::string_view text) {
  std::vector<Letter> all;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (continues && !all.empty()) all.back() += c;
    else all.push_back(Letter(1, c));
  }
  return all;
}

bool read_rows(const TomlNode& storeys, const std::vector<std::string_view>& file, PlanRows& to,
               Faults& faults) {
  bool good = true;
  if (storeys.kind == TomlNode::Array) {
    for (const TomlNode& storey : storeys.items)
      good = read_storey(storey, file, to, faults) && good;
  } else {
    good = read_storey(storeys, file, to, faults);
  }
  if (storeys.kind == TomlNode::Array && storeys.items.empty()) {
    faults.add(storeys.place, "the plan is empty", "draw at least one storey");
    return false;
  }
  if (!good) return false;
  to.rows = static_cast<int>(to.storeys[0].size());
  to.columns = static_cast<int>(to.storeys[0][0].cells.size());
  for (const std::vector<PlanRow>& storey : to.storeys) {
    const int rows = static_cast<int>(storey.size());
    const int columns = static_cast<int>(storey[0].cells.size());
    if (rows == to.rows && columns == to.columns) continue;
    faults.add(storey[0].place,
               "this storey is " + std::to_string(columns) + " x " + std::to_string(rows) +
                   " cells, the lowest one " + std::to_string(to.columns) + " x " +
                   std::to_string(to.rows),
               "draw all storeys in the same size; '#' is solid");
    good = false;
  }
  return good;
}

}  // namespace racebeam
