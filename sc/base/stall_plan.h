// stall_plan: which wires between units are held back in some clocks, and how often.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

struct stall_plan {
  /// A port at one end of a handshake: an input of a unit or, where logic of the chip stands
  /// between, an output.
  struct port {
    std::string name;  ///< "u_subdivider.ack_i"; of many alike "g_core[*].u_block_core.job_ready_o"
    bool held;         ///< what is seen of it while the channel stalls
  };
  /// Both directions of a handshake stall in the same clocks.
  struct channel {
    std::string name;
    std::vector<port> ports;
    std::string unless;  ///< wire of the chip: no stall while it is 1; or empty
  };

  std::uint64_t seed = 0;
  double begin = 0;  ///< probability in a clock without a stall that one begins
  double go_on = 0;  ///< probability in a clock with a stall that it goes on
  std::vector<channel> channels;
};

}  // namespace racebeam
