// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/legal_inputs.h"

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"

namespace racebeam {

LegalInputs::LegalInputs(const knobs& k) {
  const bool portals = k.portals_per_face > 1;
  const int portal_bits = portals ? PortalBits : 0;
  const int room_bits = portals || k.free_flight ? RoomPortBits : RoomBits;
  rules_ = {
      {"dr1", Signed, k.dr_bits},
      {"dr2", Signed, k.dr_bits},
      {"delta", Signed, k.dr_bits + 1},
      {"corner", Signed, k.corner_bits},
      {"position", Signed, k.corner_bits},
      {"half_size", Unsigned, k.corner_bits - 2},
      {"nav_position", Signed, k.navigator_bits},
      {"start_room", Unsigned, room_bits},
      {"start_", Signed, k.navigator_bits},
      {"room", Room, room_bits},
      {"nav_room", Below, (1 << room_bits) - 1},  // the last is none
      {"neighbour", Room, room_bits},
      {"tag", Unsigned, TagBits + portal_bits},
      {"top_tag", Unsigned, TagBits + portal_bits},
      {"fdata", Unsigned, FaceBits + 2 * portal_bits},
      {"fread", Unsigned, FaceBits + 2 * portal_bits},
      {"back", Unsigned, portal_bits},
      {"nav_portal", Unsigned, portal_bits},
      {"look_portal", Unsigned, portal_bits},
      {"look_way", Below, portals ? 3 : 1},
      {"sp_", Below, k.interval_stack_depth},
      {"step_size", OneBit, PixelBits},
      {"look_axis", Below, 3},
      {"nav_axis", Below, 3},
      {"hit_face", Below, 3},
      {"src", Below, 3},
      {"palette", Below, TablePalette + 1},
      {"y_i", Line, FrameLines},
  };
}

int LegalInputs::formed(const Rule& rule, int raw) {
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

int LegalInputs::of(const std::string& port, int raw) const {
  for (const Rule& rule : rules_)
    if (port.rfind(rule.start, 0) == 0) return formed(rule, raw);
  return raw;
}

}  // namespace racebeam
