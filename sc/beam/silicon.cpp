// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/silicon.h"

#include <cstddef>

#include "sc/base/probe.h"
#include "sc/beam/chip_core.h"
#include "sc/beam/scene_program.h"

namespace racebeam {

namespace {

constexpr int PlaceBits = 16, OpeningBits = 15, Faces = 6;  // of scene_rom

int room_bits(const knobs& k) {
  return Faces * PlaceBits + Faces * k.portals_per_face * OpeningBits;
}

std::uint64_t chip_register_bits(const knobs& k, const scene_program* program) {
  const chip_core chip(program);
  return register_bits(chip.vga_timing, k.clocks_per_pixel) +
         (program ? register_bits(chip.timeline, *program) : register_bits(chip.sequencer, k)) +
         register_bits(chip.camera_unit, k) + register_bits(chip.ray_stepper, k) +
         register_bits(chip.subdivider, k) + register_bits(chip.stacks, k) +
         register_bits(chip.decision_datapath, k) + register_bits(chip.navigator, k) +
         register_bits(chip.interval_fifo, k);
}

}  // namespace

silicon beam_silicon(const knob_values& values, const scene_tables* scene) {
  const knobs k = values;
  const auto* const program = static_cast<const scene_program*>(scene);
  const bool portals = k.portals_per_face > 1;
  const auto bits = [](int entries, int each) {
    return static_cast<std::uint64_t>(entries) * static_cast<std::uint64_t>(each);
  };
  const int value_bits = k.dithering == DitheringCheckered ? 3 : 2;
  const int short_bits = k.fifo_short_length_bits + value_bits;
  silicon s;
  s.memories = {
      {"interval stack", memory_row::Working,
       bits(k.interval_stack_depth, (portals ? TagPortBits : TagBits) + PixelBits)},
      {"face stack", memory_row::Working,
       bits(k.face_stack_depth, portals ? FacePortBits : FaceBits)},
      {"interval FIFO", memory_row::Working,
       bits(k.fifo_entries - 1, short_bits) + bits(1, interval_fifo_core::HeadBits + value_bits)},
      {"rooms", memory_row::Scene,
       program ? bits(static_cast<int>(program->rooms.size()), room_bits(k)) : 0},
  };
  s.multipliers = {
      {"corner by ray", 2, k.dr_bits - 1, k.corner_factor_bits, k.partial_products_cut}};
  s.register_bits = chip_register_bits(k, program);
  s.scene = {{"rooms", program ? static_cast<double>(program->rooms.size()) : 0},
             {"room_bits", program ? static_cast<double>(room_bits(k)) : 0}};
  s.quantities = {
      {"work_clocks", "busy_clocks"},
      {"picture_clocks", "clocks"},
      {"host_clocks", "0"},
      {"racing_clocks", "sample_worst / sample_pixels"},
      {"products", "2 * decisions"},
      {"roots_found", "0"},
      {"quotients", "0"},
      {"scene_bits", "rooms_entered * room_bits"},
      {"store_bits_written", "0"},
      {"store_bits_read", "0"},
      {"starved", "starved_pixels"},
  };
  return s;
}

}  // namespace racebeam
