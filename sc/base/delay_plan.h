// delay_plan: which channels between units have registers in them, and how many.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct delay_plan {
  /// Where a channel_delay is put: inputs of units, "u_subdivider.ack_i".
  struct place {
    std::string valid{};              ///< of the unit that takes: an offer
    std::vector<std::string> data{};  ///< of the same unit: what is offered
    /// Of the units that offer: the answer, as channel_delay has it; none: nobody waits for it.
    std::vector<std::string> ack{}, ready{};
    /// Wire of the chip that empties the registers while it is 1; rst_ni: while that is 0.
    std::string clear = "rst_ni";
  };
  struct channel {
    std::string name;
    place at;
    int latency;   ///< clocks, 1 or more
    int capacity;  ///< entries, `latency` or more
  };
  std::vector<channel> channels;
};

}  // namespace racebeam
