// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/program_tables.h"

#include <cstdio>

namespace racebeam {

namespace {

/// One row; `add` appends a field.
class Row {
 public:
  void add(int value, int digits) {
    char text[16];
    std::snprintf(text, sizeof text, "%s%0*x", text_.empty() ? "" : "_", digits,
                  static_cast<unsigned>(value & low_bits(4 * digits)));
    text_ += text;
  }
  void add(const vec3& values, int digits) {
    for (const int value : values) add(value, digits);
  }
  void add(const turn_row& turn) {
    add(turn.load, 1);
    add(turn.start, 3);
    add(turn.step, 3);
    add(turn.every, 5);
    add(turn.per_line, 3);
  }
  std::string line() const { return text_ + "\n"; }

 private:
  std::string text_;
};

std::string line_of(bool end, const shot_row& shot) {
  Row row;
  row.add(end, 1);
  row.add(shot.frame, 4);
  row.add(shot.start_room, 4);
  row.add(shot.start, 4);
  row.add(shot.velocity, 3);
  for (const turn_row* turn : {&shot.yaw, &shot.pitch, &shot.fov}) row.add(*turn);
  row.add(shot.restart | shot.interlace << 1 | shot.shading_b << 2 | shot.inverse << 3, 1);
  row.add(shot.pattern, 1);
  row.add(shot.colours, 6);
  row.add(shot.pattern_colours, 6);
  return row.line();
}

}  // namespace

std::string shot_table(const scene_program& program) {
  std::string table;
  for (const shot_row& shot : program.shots) table += line_of(false, shot);
  shot_row end;
  end.frame = program.frames;
  return table + line_of(true, end);
}

std::string room_table(const scene_program& program) {
  constexpr int WordDigits = 4, EdgeDigits = 1;
  std::string table;
  for (const room_row& room : program.rooms) {
    Row row;
    for (const auto& face : room.portals)
      for (const portal_row& portal : face) row.add(portal.edges, EdgeDigits);
    row.add(room.half_size, WordDigits);
    row.add(room.position, WordDigits);
    for (const auto& face : room.portals)
      for (const portal_row& portal : face)
        row.add(portal.back << RoomPortBits | portal.room, WordDigits);
    table += row.line();
  }
  return table;
}

}  // namespace racebeam
