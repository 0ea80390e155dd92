// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/knob_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "tb/base/errors.h"
#include "tb/scene/engines.h"
#include "tb/scene/table_reader.h"
#include "tb/sweep/knob_condition.h"
#include "tb/sweep/sweep_keys.h"

namespace racebeam {

namespace {

constexpr const char* Where = "where";

// The row of an entry; a fault if there is none. `others` are keys of the table that are no knobs.
const knob_row* row_of(const TomlEntry& entry, const engine& built,
                       const std::vector<std::string>& others, Faults& faults) {
  if (const knob_row* row = swept_knob(built, entry.key)) return row;
  for (const knob_row& row : built.knobs)
    if (row.of_scene && row.name == entry.key) {
      faults.add(entry.place, "knob " + quoted(entry.key) + " is the scene's",
                 "leave it out: the scene file sets it (" + std::string(row.meaning) + ")");
      return nullptr;
    }
  for (const engine* other : engines())
    for (const knob_row& row : other->knobs)
      if (row.name == entry.key) {
        faults.add(
            entry.place, "knob " + quoted(entry.key) + " is one of " + std::string(other->name),
            fmt::format("the scenes of this sweep are for {}: name scenes for {}, or leave it out",
                        built.name, other->name));
        return nullptr;
      }
  std::vector<std::string> known = swept_knobs(built);
  known.insert(known.end(), others.begin(), others.end());
  faults.add(entry.place, "unknown knob " + quoted(entry.key),
             name_help(entry.key, known) + "; `racebeam knobs` explains them");
  return nullptr;
}

bool read_value(const TomlNode& node, const knob_row& row, int& to, Faults& faults) {
  if (row.names.empty()) return read_number(node, row.name, row.min, row.max, to, faults, row.unit);
  if (node.kind != TomlNode::String) {
    wrong_type(node, row.name, "one of " + row.range() + ", in quotes", faults);
    return false;
  }
  int choice = 0;
  if (!read_word(node, row.name, row.names, choice, faults)) return false;
  to = row.min + choice;
  return true;
}

void read_range(const TomlNode& node, const knob_row& row, std::vector<int>& to, Faults& faults) {
  const std::string name = row.name;
  if (!row.names.empty()) {
    faults.add(node.place, quoted(name) + " is a range, but its values are names",
               "write a list of " + row.range());
    return;
  }
  const TableReader range(node, "range", faults, sweep_keys());
  int from = 0, last = 0, step = 1;
  const TomlNode* from_node = range.require("from", "write { from = 4, to = 16, step = 2 }");
  const TomlNode* to_node = range.require("to", "write { from = 4, to = 16, step = 2 }");
  bool good =
      from_node && read_number(*from_node, "from", row.min, row.max, from, faults, row.unit);
  good = to_node && read_number(*to_node, "to", row.min, row.max, last, faults, row.unit) && good;
  if (range.find("step")) good = range.read("step", 1, row.max - row.min, step) && good;
  if (!good) return;
  if (from > last)
    faults.add(from_node->place,
               "'from' is " + std::to_string(from) + " and 'to' is " + std::to_string(last),
               "'from' is the smaller one; a list may have any order");
  for (; from <= last; from += step) to.push_back(from);
}

void read_list(const TomlNode& node, const knob_row& row, std::vector<int>& to, Faults& faults) {
  if (node.items.empty())
    faults.add(node.place, quoted(row.name) + " has an empty list",
               "name values, or leave the knob out: it is then as in [base]");
  for (const TomlNode& item : node.items) {
    int value = 0;
    if (!read_value(item, row, value, faults)) continue;
    if (std::find(to.begin(), to.end(), value) == to.end()) to.push_back(value);
    else
      faults.warn(item.place, quoted(row.name) + " has " + row.text(value) + " twice",
                  "it counts once");
  }
}

void read_where(const TomlNode& node, SweepFile& file, Faults& faults) {
  if (node.kind != TomlNode::String) {
    wrong_type(node, Where, "a condition in quotes, \"fifo_entries <= 8\"", faults);
    return;
  }
  const bool printable = std::all_of(node.text.begin(), node.text.end(),
                                     [](unsigned char c) { return c >= 32 && c < 127; });
  if (!printable) {
    faults.add(node.place, "'where' has characters that mean nothing in it",
               "a condition over knobs: \"fifo_entries <= 8\"");
    return;
  }
  try {
    KnobCondition(*file.built, node.text);
    file.where = node.text;
    file.where_place = node.place;
  } catch (const UsageError& error) {
    faults.add(node.place, error.what(), "a condition over knobs: \"fifo_entries <= 8\"");
  }
}

bool is_table(const TomlNode& node, const std::string& name, Faults& faults) {
  if (node.kind == TomlNode::Table) return true;
  wrong_type(node, name, "a table of knobs, { fifo_entries = 8 }", faults);
  return false;
}

}  // namespace

void read_point_knobs(const TomlNode& node, SweepPoint& point, Faults& faults) {
  if (!is_table(node, "knobs", faults)) return;
  for (const TomlEntry& entry : node.entries)
    if (const knob_row* row = row_of(entry, engine_of(point.k), {}, faults)) {
      int value = 0;
      if (read_value(entry.value, *row, value, faults)) point.set_knob(*row, value);
    }
}

void read_swept_knobs(const TomlNode& node, SweepFile& file, Faults& faults) {
  if (!is_table(node, "knobs", faults)) return;
  file.knobs_place = node.place;
  for (const TomlEntry& entry : node.entries) {
    if (entry.key == Where) {
      read_where(entry.value, file, faults);
    } else if (const knob_row* row = row_of(entry, *file.built, {Where}, faults)) {
      KnobValues values{row, {}, false};
      if (entry.value.kind == TomlNode::Array) {
        read_list(entry.value, *row, values.values, faults);
      } else if (entry.value.kind == TomlNode::Table) {
        read_range(entry.value, *row, values.values, faults);
      } else {
        int value = 0;
        values.fixed = true;
        if (read_value(entry.value, *row, value, faults)) values.values = {value};
      }
      file.knobs.push_back(std::move(values));
    }
  }
}

}  // namespace racebeam
