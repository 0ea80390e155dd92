// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/base/unit.h"

namespace racebeam {

std::vector<any_port*> ports_of(const sc_core::sc_module& module) {
  std::vector<any_port*> ports;
  for (auto* child : module.get_child_objects())
    if (auto* port = dynamic_cast<any_port*>(child)) ports.push_back(port);
  return ports;
}

}  // namespace racebeam
