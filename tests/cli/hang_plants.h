// Mistakes that are planted in the RTL of units: those that stop the chip, and the worst of those
// that cannot.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace racebeam {

struct Plant {
  const char *name, *engine, *unit;  ///< of the test; whose chip; that the chain must end with
  std::string file;                  ///< of rtl/, changed
  const char *right, *wrong;         ///< text of it, and what stands there instead
  const char* why = "";              ///< of those that cannot stop the chip
  std::vector<const char*> more{};   ///< of the command line, after the scene if it is another one
};
void PrintTo(const Plant& plant, std::ostream* out);

/// One of each engine, which take seconds.
std::vector<Plant> quick_plants();
std::vector<Plant> other_plants();
/// A unit with a row here cannot stop the chip, whatever its outputs are.
std::vector<Plant> harmless_plants();

}  // namespace racebeam
