// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/chip_deposit.h"

namespace racebeam {

// x and y are stored without the six bits that a flight along z keeps, of the room only its j.
std::vector<std::pair<std::string, std::uint64_t>> chip_deposits(int frame,
                                                                 const navigator_core& place) {
  const auto raw = [](int value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
  };
  return {{"u_sequencer.frame_q", raw(frame)},
          {"u_navigator.g_along_z.position_x_q", raw(place.position_q[0] >> 6)},
          {"u_navigator.g_along_z.position_y_q", raw(place.position_q[1] >> 6)},
          {"u_navigator.g_along_z.position_z_q", raw(place.position_q[2])},
          {"u_navigator.g_along_z.room_j_q", raw(place.room_q >> 4)}};
}

}  // namespace racebeam
