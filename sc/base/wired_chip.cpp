// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/base/wired_chip.h"

namespace racebeam {

namespace {

void add_modules(std::vector<sc_core::sc_module*>& all, const sc_core::sc_module& in) {
  for (auto* child : in.get_child_objects()) {
    auto* module = dynamic_cast<sc_core::sc_module*>(child);
    if (!module) continue;
    all.push_back(module);
    add_modules(all, *module);
  }
}

}  // namespace

std::vector<sc_core::sc_module*> wired_chip::modules() const {
  std::vector<sc_core::sc_module*> all;
  add_modules(all, *this);
  return all;
}

}  // namespace racebeam
