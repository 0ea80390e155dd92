// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/legal_inputs.h"

#include "sc/constants.h"
#include "sc/fixed_point.h"

namespace racebeam {

namespace {

enum Form { Unsigned, Signed, Below, OneBit, Room, Line };

/// Inputs whose port is wider than the chip's value, or that have fewer values than bits.
struct Rule {
  const char* start;  ///< of the port's name
  Form form;
  int size;  ///< bits, or number of values
};

constexpr Rule Rules[] = {
    {"dr1", Signed, DrBits},
    {"dr2", Signed, DrBits},
    {"delta", Signed, DrBits + 1},
    {"corner", Signed, CornerBits},
    {"position", Signed, CornerBits},
    {"half_size", Unsigned, CornerBits - 2},
    {"nav_position", Signed, NavigatorBits},
    {"start_room", Unsigned, RoomBits},
    {"start_", Signed, NavigatorBits},
    {"room", Room, RoomBits},
    {"nav_room", Below, (1 << RoomBits) - 1},  // the last is none
    {"neighbour", Room, RoomBits},
    {"tag", Unsigned, TagBits},
    {"top_tag", Unsigned, TagBits},
    {"fdata", Unsigned, FaceBits},
    {"fread", Unsigned, FaceBits},
    {"back", Unsigned, 0},
    {"nav_portal", Unsigned, 0},
    {"look_portal", Unsigned, 0},
    {"look_way", Unsigned, 0},
    {"sp_", Below, 4},
    {"step_size", OneBit, 10},
    {"look_axis", Below, 3},
    {"nav_axis", Below, 3},
    {"hit_face", Below, 3},
    {"src", Below, 3},
    {"palette", Below, 4},
    {"y_i", Line, FrameLines},
};

int formed(const Rule& rule, int raw) {
  switch (rule.form) {
    case Unsigned: return raw & low_bits(rule.size);
    case Signed: return wrap_signed(raw, rule.size);
    case Below: return raw % rule.size;
    case OneBit: return 1 << raw % rule.size;
    case Line: return FirstLine + raw % rule.size;
    default: {
      const int room = raw & low_bits(rule.size);
      return room == low_bits(rule.size) ? SolidRoom : room;
    }
  }
}

}  // namespace

int legal_input(const std::string& port, int raw) {
  for (const Rule& rule : Rules)
    if (port.rfind(rule.start, 0) == 0) return formed(rule, raw);
  return raw;
}

}  // namespace racebeam
