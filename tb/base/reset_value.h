// Which inputs of a unit reset it: by their names.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// The value of a port that resets, -1: it does not reset.
inline int reset_value(const std::string& port) {
  if (port == "rst_ni") return 0;
  return port.find("reset") != std::string::npos ? 1 : -1;
}

}  // namespace racebeam
