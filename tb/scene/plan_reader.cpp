// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_reader.h"

#include <algorithm>
#include <map>
#include <set>

#include "tb/scene/plan_grid.h"
#include "tb/scene/plan_rows.h"
#include "tb/scene/plan_style.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

constexpr int NicheDepth = 32;  // of a skylight above which there is nothing, without a slab

class PlanBuilder {
 public:
  PlanBuilder(std::vector<Room>& rooms, Faults& faults) : rooms_(rooms), faults_(faults) {}

  // `sets` are those of the plans before.
  void read(const TomlNode& node, const std::vector<std::string_view>& file,
            std::set<std::string>& sets) {
    const TableReader plan(node, "plan", faults_);
    if (node.kind != TomlNode::Table) return;
    style_ = read_style(plan);
    const bool own_set = set_is_new(plan, sets);
    const TomlNode* storeys = plan.require("storeys", "draw the plan: storeys = \"\"\"...\"\"\"");
    if (!storeys || !read_rows(*storeys, file, rows_, faults_)) return;
    if (!letters_are_known() || !count_is_possible(plan)) return;
    warn_of_unused(plan);
    grid_ = lay_out(plan, style_, rows_);
    if (!own_set) return;
    style_.opening = std::min(style_.opening, grid_.closest());
    make_cells();
    connect_columns();
    connect_storeys();
  }

 private:
  struct Cell {
    int room;
    const CellKind* kind;
  };

  // Calls use(storey, row, column, letter, place) for all cells that are not solid.
  template <class Use>
  void for_each_cell(const Use& use) const {
    for (int s = 0; s < static_cast<int>(rows_.storeys.size()); ++s)
      for (int r = 0; r < rows_.rows; ++r) {
        const PlanRow& row = rows_.storeys[s][r];
        for (int c = 0; c < rows_.columns; ++c)
          if (row.cells[c] != "#")
            use(s, r, c, row.cells[c], Place{row.place.line, row.place.column + c});
      }
  }

  bool set_is_new(const TableReader& plan, std::set<std::string>& sets) {
    if (sets.insert(style_.set).second) return true;
    const TomlNode* set = plan.find("set");
    faults_.add(set ? set->place : plan.place(), "two plans have the set " + quoted(style_.set),
                "give each plan a set of its own: the names of its cells begin with it");
    return false;
  }

  bool letters_are_known() {
    bool good = true;
    for_each_cell([&](int, int, int, const Letter& letter, Place place) {
      if (style_.kinds.count(letter)) return;
      good = false;
      faults_.add(place, quoted(letter) + " is no kind of cell",
                  "describe it: [plan.cells] X = { height = 256 }; or use '#', '.', '@'");
    });
    return good;
  }

  bool count_is_possible(const TableReader& plan) {
    int cells = 0;
    for_each_cell([&](int, int, int, const Letter& letter, Place) { ++cells, ++used_[letter]; });
    if (cells == 0)
      faults_.add(plan.find("storeys")->place, "the plan is empty",
                  "draw at least one open cell: '.' or '@'");
    const int longest = std::max(rows_.columns, rows_.rows);
    const bool fits = cells <= MaxRooms && longest <= MaxRooms;
    if (!fits)
      faults_.add(plan.find("storeys")->place,
                  cells > MaxRooms ? "the plan has " + std::to_string(cells) + " rooms"
                                   : "the plan is " + std::to_string(longest) + " cells long",
                  "at most " + std::to_string(MaxRooms) + " fit the room number");
    return cells > 0 && fits;
  }

  void warn_of_unused(const TableReader& plan) {
    const TomlNode* cells = plan.find("cells");
    if (!cells) return;
    for (const TomlEntry& entry : cells->entries)
      if (!used_.count(entry.key))
        faults_.warn(entry.place, "no cell of the plan is " + quoted(entry.key),
                     "draw one, or leave out the kind");
  }

  std::string cell_id(int s, int r, int c, const Letter& letter) {
    const std::string& name = style_.kinds.at(letter).id;
    if (name.empty())
      return style_.named(std::to_string(s + 1) + "." + std::to_string(r + 1) + "." +
                          std::to_string(c + 1));
    return used_.at(letter) == 1 ? name : name + "." + std::to_string(++numbered_[letter]);
  }

  void make_cells() {
    columns_.resize(static_cast<std::size_t>(rows_.rows) * rows_.columns);
    for_each_cell([&](int s, int r, int c, const Letter& letter, Place place) {
      const CellKind& kind = style_.kinds.at(letter);
      const int floor =
          style_.origin[1] - s * (style_.height + style_.slab) - kind.floor;  // y points down
      Room room;
      room.id = cell_id(s, r, c, letter);
      room.set = style_.set;
      room.place = place;
      const int row = rows_.rows - 1 - r;  // from the south
      room.centre = {grid_.middles[0][c], floor - kind.height / 2, grid_.middles[1][row]};
      room.half_size = {grid_.edges[0][c] / 2, kind.height / 2, grid_.edges[1][row] / 2};
      columns_[r * rows_.columns + c].push_back({static_cast<int>(rooms_.size()), &kind});
      rooms_.push_back(std::move(room));
    });
  }

  void connect_touching(const std::vector<Cell>& from, int face, const std::vector<Cell>& to) {
    for (const Cell& a : from)
      for (const Cell& b : to)
        if (rooms_touch(rooms_[a.room], face, rooms_[b.room]))
          connect(rooms_, a.room, face, b.room);
  }

  void connect_columns() {
    for (int r = 0; r < rows_.rows; ++r)
      for (int c = 0; c < rows_.columns; ++c) {
        const int at = r * rows_.columns + c;
        if (c + 1 < rows_.columns) connect_touching(columns_[at], East, columns_[at + 1]);
        if (r > 0) connect_touching(columns_[at], North, columns_[at - rows_.columns]);
      }
  }

  // Adds the shaft between two heights, y pointing down; `room` gives its place and its name.
  int add_shaft(int room, const char* end, int ceiling, int floor) {
    Room shaft;
    shaft.id = rooms_[room].id + end;
    shaft.set = style_.set;
    shaft.place = rooms_[room].place;
    shaft.centre = {rooms_[room].centre[0], (ceiling + floor) / 2, rooms_[room].centre[2]};
    shaft.half_size = {style_.opening / 2, (floor - ceiling) / 2, style_.opening / 2};
    rooms_.push_back(shaft);
    return static_cast<int>(rooms_.size()) - 1;
  }

  void open_between(int lower, int upper) {
    const int ceiling = rooms_[lower].low(1), floor = rooms_[upper].high(1);
    if (ceiling < floor) return;  // they overlap: a fault that the checker finds
    if (ceiling == floor) {
      connect(rooms_, lower, Up, upper);
      return;
    }
    const int shaft = add_shaft(lower, ".up", floor, ceiling);
    connect(rooms_, lower, Up, shaft);
    connect(rooms_, shaft, Up, upper);
  }

  void connect_storeys() {
    const int niche = style_.slab > 0 ? style_.slab : NicheDepth;
    for (std::vector<Cell>& column : columns_) {
      if (column.empty()) continue;
      std::stable_sort(column.begin(), column.end(), [&](const Cell& a, const Cell& b) {
        return rooms_[a.room].high(1) > rooms_[b.room].high(1);  // lowest first
      });
      for (std::size_t i = 0; i + 1 < column.size(); ++i)
        if (column[i].kind->skylight || column[i + 1].kind->hole)
          open_between(column[i].room, column[i + 1].room);
      const int lowest = column.front().room, highest = column.back().room;
      if (column.front().kind->hole) {
        const int floor = rooms_[lowest].high(1);
        connect(rooms_, lowest, Down, add_shaft(lowest, ".down", floor, floor + niche));
      }
      if (column.back().kind->skylight) {
        const int ceiling = rooms_[highest].low(1);
        connect(rooms_, highest, Up, add_shaft(highest, ".up", ceiling - niche, ceiling));
      }
    }
  }

  std::vector<Room>& rooms_;
  Faults& faults_;
  PlanStyle style_;
  std::map<Letter, int> used_, numbered_;
  PlanRows rows_;
  PlanGrid grid_;
  std::vector<std::vector<Cell>> columns_;  // row, column: the cells above each other
};

}  // namespace

void read_plans(const TomlNode& node, std::string_view text, std::vector<Room>& rooms,
                Faults& faults) {
  const std::vector<std::string_view> file = split_lines(text);
  std::set<std::string> sets;
  if (node.kind != TomlNode::Array) PlanBuilder(rooms, faults).read(node, file, sets);
  for (const TomlNode& plan : node.items) {
    if (rooms.size() > MaxRooms) return;  // a fault of its own
    PlanBuilder(rooms, faults).read(plan, file, sets);
  }
}

}  // namespace racebeam
