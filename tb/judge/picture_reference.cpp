// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/picture_reference.h"

namespace racebeam {

const std::vector<std::string>& picture_reference_names() {
  static const std::vector<std::string> names = {"geometry", "trace4", "base"};
  return names;
}

}  // namespace racebeam
