// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/beam_twins.h"

#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"
#include "sc/beam/knob_parameters.h"
#include "sc/beam/scene_program.h"
#include "tb/scene/program_tables.h"
#include "tb/twin/table_file.h"

namespace racebeam {

namespace {

std::vector<PluginMaker::Setting> tables(const std::string& unit, const scene_program* program) {
  if (!program) return {};
  const std::string what = "the scene's table of ";
  if (unit == "timeline")
    return {{"Shots", std::to_string(program->shots.size()), what + "shots"},
            {"ShotFile", table_file(shot_table(*program)), what + "shots"}};
  if (unit == "scene_rom")
    return {{"Rooms", std::to_string(program->rooms.size()), what + "rooms"},
            {"RoomFile", table_file(room_table(*program)), what + "rooms"}};
  return {};
}

using Raw = std::uint64_t;

auto in_bits(int bits) {
  return [bits](Raw raw) { return bits == 0 ? 0 : raw_bits(raw, bits); };
}
auto in_signed_bits(int bits) {
  return [bits](Raw raw) { return static_cast<Raw>(signed_bits(raw, bits)); };
}
Raw step_size(Raw raw) {
  const bool is_one = raw != 0 && (raw & (raw - 1)) == 0 && raw >> PixelBits == 0;
  return is_one ? raw : Raw{1} << raw % PixelBits;
}
auto below(int count) {
  return [count](Raw raw) { return raw % static_cast<Raw>(count); };
}

}  // namespace

PluginMaker beam_plugins(const knobs& k, const scene_tables* scene, bool traced) {
  const auto* program = static_cast<const scene_program*>(scene);
  return PluginMaker(
      knob_parameters(k), [program](const std::string& unit) { return tables(unit, program); },
      traced);
}

LegalInputs beam_inputs(const knobs& k) {
  const bool portals = k.portals_per_face > 1;
  const int portal_bits = portals ? PortalBits : 0;
  const int room_bits = portals || k.free_flight ? RoomPortBits : RoomBits;
  const auto room = [none = static_cast<Raw>(low_bits(room_bits))](Raw raw) {
    return (raw & none) == none ? Raw{SolidRoom} : raw & none;
  };
  return LegalInputs({
      {"dr1", in_signed_bits(k.dr_bits)},
      {"dr2", in_signed_bits(k.dr_bits)},
      {"delta", in_signed_bits(k.dr_bits + 1)},
      {"corner", in_signed_bits(k.corner_bits)},
      {"position", in_signed_bits(k.corner_bits)},
      {"half_size", in_bits(k.corner_bits - 2)},
      {"nav_position", in_signed_bits(k.navigator_bits)},
      {"start_room", in_bits(room_bits)},
      {"start_", in_signed_bits(k.navigator_bits)},
      {"room", room},
      {"nav_room", below((1 << room_bits) - 1)},  // the last is none
      {"neighbour", room},
      {"tag", in_bits(TagBits + portal_bits)},
      {"top_tag", in_bits(TagBits + portal_bits)},
      {"fdata", in_bits(FaceBits + 2 * portal_bits)},
      {"fread", in_bits(FaceBits + 2 * portal_bits)},
      {"back", in_bits(portal_bits)},
      {"nav_portal", in_bits(portal_bits)},
      {"look_portal", in_bits(portal_bits)},
      {"look_way", below(portals ? 3 : 1)},
      {"sp_", below(k.interval_stack_depth)},
      {"step_size", step_size},
      {"look_axis", below(3)},
      {"nav_axis", below(3)},
      {"hit_face", below(3)},
      {"src", below(3)},
      {"palette", below(TablePalette + 1)},
      scan_line(),
  });
}

LegalInputs room_table_inputs(const knobs& k, const scene_tables* scene) {
  constexpr Raw Others = 4;  // one in so many stays what it is
  if (!scene) return beam_inputs(k);
  const std::size_t rooms = static_cast<const scene_program*>(scene)->rooms.size();
  const auto near = [rooms](Raw raw) { return raw % Others == 0 ? raw : raw % (rooms + 1); };
  return beam_inputs(k).preceded_by({"room", near, true});
}

}  // namespace racebeam
