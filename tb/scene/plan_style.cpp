// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_style.h"

#include <algorithm>

namespace racebeam {

namespace {

constexpr int LargestSize = 8192;
constexpr int LargestOrigin = 1000000;

class StyleReader {
 public:
  explicit StyleReader(Faults& faults) : faults_(faults) {}

  PlanStyle read(const TableReader& plan) {
    read_sizes(plan);
    read_kinds(plan);
    return style_;
  }

 private:
  void even(const TableReader& table, const std::string& key, int low, int& to) {
    if (table.read(key, low, LargestSize, to)) check_even(*table.find(key), key, to);
  }

  void check_even(const TomlNode& node, const std::string& key, int& value) {
    if (value % 2 == 0) return;
    faults_.add(node.place, "'" + key + "' is odd",
                "make it even: rooms have whole centres and half sizes");
    value -= value % 2;
  }

  void read_cell(const TableReader& plan) {
    int edge[2] = {256, 256};
    const TomlNode* cell = plan.find("cell");
    if (cell && cell->kind == TomlNode::Array) {
      for (int i = 0; i < 2; ++i)
        if (cell->items.size() == 2 &&
            read_number(cell->items[i], "cell", 2, LargestSize, edge[i], faults_))
          check_even(cell->items[i], "cell", edge[i]);
      if (cell->items.size() != 2)
        faults_.add(cell->place, "'cell' has not two numbers", "write one, or [x, z]");
    } else if (cell) {
      even(plan, "cell", 2, edge[0]);
      edge[1] = edge[0];
    }
    for (int i = 0; i < 2; ++i) style_.edges[i].assign(1, edge[i]);
  }

  // The edges of columns or rows one by one, in place of `cell`.
  void read_edges(const TableReader& plan, const std::string& key, std::vector<int>& to) {
    const TomlNode* node = plan.find(key);
    if (!node) return;
    if (node->kind != TomlNode::Array || node->items.empty()) {
      faults_.add(node->place, "'" + key + "' is no list of numbers",
                  "write one for each, or the first ones, which repeat: " + key + " = [160, 352]");
      return;
    }
    std::vector<int> edges(node->items.size(), 2);
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (read_number(node->items[i], key, 2, LargestSize, edges[i], faults_))
        check_even(node->items[i], key, edges[i]);
    to = std::move(edges);
  }

  int smallest_edge() const {
    int smallest = LargestSize;
    for (const std::vector<int>& edges : style_.edges)
      smallest = std::min(smallest, *std::min_element(edges.begin(), edges.end()));
    return smallest;
  }

  void read_sizes(const TableReader& plan) {
    read_cell(plan);
    read_edges(plan, "widths", style_.edges[0]);
    read_edges(plan, "depths", style_.edges[1]);
    even(plan, "height", 2, style_.height);
    even(plan, "slab", 0, style_.slab);
    style_.opening = std::max(2, smallest_edge() * 3 / 4 / 2 * 2);
    even(plan, "opening", 2, style_.opening);
    plan.read("origin", -LargestOrigin, LargestOrigin, style_.origin);
    if (const TomlNode* origin = plan.find("origin"))
      for (int& value : style_.origin) check_even(*origin, "origin", value);
    plan.read("set", style_.set, true);
  }

  void read_kinds(const TableReader& plan) {
    style_.kinds["."].height = style_.kinds["@"].height = style_.height;
    style_.kinds["@"].id = style_.named("start");
    const TomlNode* cells = plan.find("cells");
    if (!cells) return;
    if (cells->kind != TomlNode::Table) {
      faults_.add(cells->place, std::string("'cells' is ") + cells->kind_name(),
                  "it must be a table: A = { height = 256 }");
      return;
    }
    for (const TomlEntry& entry : cells->entries) {
      if (letters(entry.key).size() != 1 || entry.key == "#") {
        faults_.add(entry.place, quoted(entry.key) + " cannot be a kind of cell",
                    "use one character that is not '#', which is always solid");
        continue;
      }
      CellKind& kind = style_.kinds[entry.key];
      kind.height = style_.height;
      const TableReader table(entry.value, "cells", faults_);
      even(table, "height", 2, kind.height);
      even(table, "floor", -LargestSize, kind.floor);
      table.read("skylight", kind.skylight);
      table.read("hole", kind.hole);
      table.read("id", kind.id);
    }
  }

  Faults& faults_;
  PlanStyle style_;
};

}  // namespace

PlanStyle read_style(const TableReader& plan) { return StyleReader(plan.faults()).read(plan); }

}  // namespace racebeam
