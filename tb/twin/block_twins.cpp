// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/block_twins.h"

#include <cstdint>

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
      return raw / BlockSide % blocks * BlockSide;
    };
  };
  // Mostly a number that is not 0 when it is converted; any at times.
  constexpr Raw Seldom = 8, LeastExponent = 104, Exponents = 32, Exponent = 0xff;
  constexpr int Mantissa = 23;
  const auto mostly_kept = [](Raw raw) {
    if (raw % Seldom == 0) return raw;
    const Raw exponent = LeastExponent + (raw >> Mantissa & Exponent) % Exponents;
    return (raw & ~(Exponent << Mantissa)) | exponent << Mantissa;
  };
  const auto always = [](int value) { return [value](Raw) { return static_cast<Raw>(value); }; };
  return LegalInputs({
      {"float_i", mostly_kept, true},
      {"job_x_i", blocks_of(k.columns())},
      {"job_y_i", blocks_of(k.rows())},
      {"width_i", always(k.columns())},
      {"height_i", always(k.rows())},
      {"spheres_i", [](Raw raw) { return raw % (BlockEntries + 1); }},
  });
}

}  // namespace racebeam
