// What the registers of RTL have before its first clock: Verilator's usual 0, or anything else.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

extern "C" {

enum rtl_registers { RtlZeros, RtlOnes, RtlRandom };

/// Of registers, memories and other variables, and of bits that the source calls x; what an initial
/// block writes has that instead.
struct rtl_power_up {
  rtl_registers registers;
  int seed;  ///< of RtlRandom, from 1 on
};

/// The symbol "rtl_power_up_1" of a plug-in: of the instances that it makes from now on.
typedef void (*rtl_power_up_setter)(rtl_power_up start);
}

namespace racebeam {

/// While it lives, instances of plug-ins power up so. One at a time.
class RtlPowerUp {
 public:
  explicit RtlPowerUp(rtl_power_up start);
  ~RtlPowerUp();
  RtlPowerUp(const RtlPowerUp&) = delete;
  RtlPowerUp& operator=(const RtlPowerUp&) = delete;

  /// That of instances which are made now.
  static rtl_power_up now();
};

/// "zeros", "ones", "seed 7".
std::string power_up_text(const rtl_power_up& start);

}  // namespace racebeam
