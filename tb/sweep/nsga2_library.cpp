// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/nsga2_library.h"

#include "tb/base/program_library.h"

namespace racebeam {

const Nsga2Library& nsga2_library() {
  static const void* const library = open_program_library(
      "libracebeam_search.so", "racebeam_nsga2_library",
      "nsga2 is built and installed with the program where pagmo is (apt install libpagmo-dev, "
      "then scripts/build racebeam); or search with [search] method = \"sobol\"");
  return *static_cast<const Nsga2Library*>(library);
}

}  // namespace racebeam
