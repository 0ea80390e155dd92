// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/wire_place.h"

#include <string>

#include "sc/swap/rtl_library.h"

namespace racebeam {

any_wire& wire_of(any_port& pin) {
  auto& port = dynamic_cast<sc_core::sc_port_base&>(pin);
  if (auto* wire = dynamic_cast<any_wire*>(port.get_interface())) return *wire;
  throw RtlError(std::string(port.name()) + " is bound to another channel than a racebeam::wire");
}

}  // namespace racebeam
