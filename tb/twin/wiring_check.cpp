// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/wiring_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace racebeam {

namespace {

constexpr std::uint64_t Settling = 1600;  // clocks of a line, until registers without reset are set

}  // namespace

WiringCheck::WiringCheck(rtl_instance& top, const sc_core::sc_module& chip) {
  std::set<std::string> visible;
  for (const probe& signal : top.probes()) visible.insert(signal.name);
  std::string missing;
  for (const auto* child : chip.get_child_objects()) {
    const auto* unit = dynamic_cast<const sc_core::sc_module*>(child);
    if (!unit) continue;
    for (any_port* pin : ports_of(*unit)) {
      const std::string name = pin->port_name();
      if (name == "clk_i") continue;
      const std::string signal = std::string(unit->basename()) + "." + name;
      if (visible.count(signal) != 0)
        ports_.push_back({unit->basename(), name, pin->is_input(), pin, top.signal(signal)});
      else missing = signal;
    }
  }
  // A flattened netlist has none of them, and there is nothing to look at.
  if (!ports_.empty() && !missing.empty())
    throw RtlError("there is no signal " + missing + " in racebeam_top");
}

void WiringCheck::join() {
  for (Port& port : ports_) port.wire = port.pin->contents();
  for (Port& in : ports_) {
    if (!in.is_input) continue;
    for (std::size_t n = 0; n < ports_.size(); ++n)
      if (!ports_[n].is_input && ports_[n].wire.bit == in.wire.bit &&
          ports_[n].wire.word == in.wire.word)
        in.driver = static_cast<int>(n);
  }
  joined_ = true;
}

void WiringCheck::look(std::uint64_t clock) {
  if (!joined_) join();
  if (!found_.empty()) return;
  if (const std::string wire = wrong_wire(); !wire.empty()) {
    found_ = fmt::format("{}\nNo unit is to blame: the wiring of racebeam_top is wrong.", wire);
  } else if (clock > Settling && std::any_of(ports_.begin(), ports_.end(), differs)) {
    found_ = fmt::format(
        "the units inside differ first after {} clocks: {}.\nThe wiring is good so far: racebeam "
        "verify that unit.",
        clock, wrong_outputs());
  }
}

// A wire has one value at both ends, whatever the units do.
std::string WiringCheck::wrong_wire() const {
  for (const Port& in : ports_) {
    if (!in.is_input) continue;
    const bool from_pin = in.driver == NoDriver;
    const Port& driver = from_pin ? in : ports_[static_cast<std::size_t>(in.driver)];
    const std::uint64_t want = from_pin ? in.wire.value() : driver.rtl.read();
    if (in.rtl.read() == want) continue;
    return fmt::format("{} has {:#x} instead of {:#x}, the value of {}.", in.full_name(),
                       in.rtl.read(), want, from_pin ? "a pin of the chip" : driver.full_name());
  }
  return {};
}

// Those of units whose inputs are right, if there are such.
std::string WiringCheck::wrong_outputs() const {
  std::set<std::string> misled;
  for (const Port& in : ports_)
    if (in.is_input && differs(in)) misled.insert(in.unit);
  std::string own, all;
  for (const Port& out : ports_) {
    if (out.is_input || !differs(out)) continue;
    std::string& names = misled.count(out.unit) ? all : own;
    names += (names.empty() ? "" : ", ") + out.full_name();
  }
  return own.empty() ? all : own;
}

std::string WiringCheck::text() const {
  if (!found_.empty()) return found_;
  if (ports_.empty()) return "its units are not to be seen: racebeam verify them one by one";
  return "no port of a unit differs: the wiring of racebeam_top between the units and the pins "
         "does";
}

}  // namespace racebeam
