// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_power_up.h"

namespace racebeam {

namespace {

constexpr rtl_power_up Usual{RtlZeros, 0};
rtl_power_up current = Usual;

}  // namespace

RtlPowerUp::RtlPowerUp(rtl_power_up start) { current = start; }
RtlPowerUp::~RtlPowerUp() { current = Usual; }
rtl_power_up RtlPowerUp::now() { return current; }

std::string power_up_text(const rtl_power_up& start) {
  if (start.registers == RtlRandom) return "seed " + std::to_string(start.seed);
  return start.registers == RtlOnes ? "ones" : "zeros";
}

}  // namespace racebeam
