// block_core: draws blocks of 16 x 16 pixels, one after the other.
//
// What    A job is a block's upper left pixel. Four corner rays ask whether a sphere can be in it;
//         if none, the block is cleared. Else, pixel by pixel: unit vector of the place on the
//         screen, all spheres in groups of `lanes`, of the nearest hit light and the ray that
//         leaves it, up to max_passes times. Colours add up, every pass in full; a channel is
//         bits 28..12 of the sum, at most 255; a pixel that hits nothing has the background. Eight
//         pixels leave as three words, one a colour.
// Cycles  state (state_o)   clocks
//         BlockIdle         until a job; job_ready_o
//         BlockJob          2: the first pixel's place, x and y
//         BlockCorner       4 unit vectors: corners ul, bl, br, ur, 15 steps apart; cull = cone:
//                           1, of the block's middle
//         BlockCull         1 a sphere (corners, lanes below 4: 4 / lanes), up to the first that
//                           keeps the block: b * b + rv > 0 in any of the corners; cone: with
//                           ahead = -b of the middle and reach = radius + 1/64 + ahead * sine,
//                           reach >= 0 and (|pose|^2 - b * b) * cosine2 <= reach * reach
//         BlockClear        6 a row: two words each of red, green, blue
//         BlockPixel        a unit vector, 3 + 3 * newton_steps
//         BlockGroup        1 a group in the first pass, 2 in later ones
//         BlockNear         block_root's, 1, 9 or 12, a lane of the group with d > 0, lowest first:
//                           t = -b - root(d); the nearest t > 0 below BlockFar counts
//         BlockDecide       1
//         BlockShade        block_shade's
//         BlockShadow       shadow_rays: the unit vector of the way from the hit to the light, and
//                           1 for its length, the product of both
//         BlockShadowGroup  2 a group: the spheres that the way crosses, the hit's own left out
//         BlockShadowNear   as BlockNear, up to the first t > 0 below the length: what the pass has
//                           lit, its highlight too, is dark and is not added
//         BlockStore        1
//         BlockWords        3 after every eighth pixel: red, green, blue
//         cull = off: from BlockJob to BlockPixel. Without spheres there is neither BlockCull nor
//         BlockGroup. After BlockShade, or its shadow ray, the next pass begins with BlockGroup;
//         after the last pass comes BlockStore. A dark pixel is black, not the background.
// Comb    none.
// Stall   BlockClear and BlockWords wait for word_ready_i.
// Reset   rst_ni = 0: BlockIdle, BlockNoEvent. Places, counts and numbers are without reset.
// Address of a word: plane * (width * height / 8) + y * (width / 8) + x / 8; rows of a block below
//         the picture are not drawn.
// Knobs   lanes, newton_steps, specular_squarings, max_passes, root, shadow_rays, cull,
//         background, size: parameters Lanes, NewtonSteps, SpecularSquarings, MaxPasses, Root,
//         ShadowRays, Cull, Background, PictureWidth, PictureHeight.
// Twin    rtl/block/block_core.sv
// Test    tests/block/block_core_test.cpp
// Source  article "The Integer Raytracer".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_core_core.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Pins of block_core.
class block_core_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // block_scheduler
  in_port<1> job_valid_i{"job_valid_i"};
  in_port<BlockPlaceBits> job_x_i{"job_x_i"};
  in_port<BlockPlaceBits> job_y_i{"job_y_i"};
  out_port<1> job_ready_o{"job_ready_o"};
  out_port<1> busy_o{"busy_o"};
  // block_convert
  in_port<1> write_i{"write_i"};
  in_port<BlockFieldBits> field_i{"field_i"};  // block_field
  in_port<BlockIndexBits> index_i{"index_i"};  // of the sphere
  in_port<BlockBits> value_i{"value_i"};       // signed
  in_port<BlockBits> eye_k_i{"eye_k_i"};       // signed, of the axis of a centre
  // World
  in_port<BlockCountBits> spheres_i{"spheres_i"};  // 0..64
  axes_in<BlockBits> eye_i{"eye", "_i"};           // signed
  axes_in<BlockBits> light_i{"light", "_i"};       // signed
  axes_in<BlockBits> start_i{"start", "_i"};       // signed, of block (0, 0)
  in_port<BlockBits> ax_i{"ax_i"};                 // from pixel to pixel
  in_port<BlockBits> ay_i{"ay_i"};                 // from row to row
  in_port<BlockBits> cone_sine_i{"cone_sine_i"};   // of the angle of a block; cull = cone
  in_port<BlockBits> cone_cosine2_i{"cone_cosine2_i"};
  // block_bus
  out_port<1> word_valid_o{"word_valid_o"};
  out_port<BlockAddressBits> word_address_o{"word_address_o"};
  out_port<64> word_o{"word_o"};
  in_port<1> word_ready_i{"word_ready_i"};
  // Waveforms and counters
  out_port<BlockStateBits> state_o{"state_o"};  // block_state
  out_port<BlockEventBits> event_o{"event_o"};  // block_event, of the clock before

  explicit block_core_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_core: its core behind the pins.
class block_core : public block_core_pins, public probed {
 public:
  using pins = block_core_pins;
  static constexpr const char* unit_name = "block_core";

  block_core(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  block_core_core::inputs inputs() const;
  void seq();
  void drive();

  const block_knobs knobs_;
  block_core_core core_;
  bool asleep_ = true;
};

}  // namespace racebeam
