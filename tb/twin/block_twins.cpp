// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/block_twins.h"

#include <cstdint>

#include "sc/base/constants.h"
#include "sc/block/block_parameters.h"
#include "sc/block/codes.h"

namespace racebeam {

PluginMaker block_plugins(const block_knobs& k, bool traced) {
  return PluginMaker(block_parameters(k), {}, traced);
}

LegalInputs block_inputs_of(const block_knobs& k) {
  using Raw = std::uint64_t;
  const auto blocks_of = [](int pixels) {
    return [blocks = static_cast<Raw>((pixels + BlockSide - 1) / BlockSide)](Raw raw) {
      return raw % blocks * BlockSide;
    };
  };
  const auto always = [](int value) { return [value](Raw) { return static_cast<Raw>(value); }; };
  return LegalInputs({
      {"job_x_i", blocks_of(k.columns())},
      {"job_y_i", blocks_of(k.rows())},
      {"width_i", always(k.columns())},
      {"height_i", always(k.rows())},
      {"spheres_i", [](Raw raw) { return raw % (BlockEntries + 1); }},
      {"y_i", [](Raw raw) { return static_cast<Raw>(FirstLine) + raw % FrameLines; }},
  });
}

}  // namespace racebeam
