// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wiring_check.h"

#include <fmt/format.h>

#include <algorithm>

namespace racebeam {

namespace {

constexpr std::uint64_t Settling = 1600;  // clocks of a line, until registers without reset are set

}  // namespace

WiringCheck::WiringCheck(rtl_instance& top, const sc_core::sc_module& chip) : top_(top) {
  for (const auto* child : chip.get_child_objects()) {
    const auto* unit = dynamic_cast<const sc_core::sc_module*>(child);
    if (!unit) continue;
    for (any_port* pin : ports_of(*unit)) {
      const std::string name = pin->port_name();
      if (name == "clk_i") continue;
      ports_.push_back({unit->basename(), name, pin->is_input(), pin,
                        top.signal(std::string(unit->basename()) + "." + name)});
    }
  }
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
  if (!found_.empty() || clock <= Settling) return;
  if (std::none_of(ports_.begin(), ports_.end(), [&](const Port& p) { return differs(p); })) return;
  found_ = fmt::format("the units inside differ first after {} clocks: {}", clock, finding());
}

// An input that differs from its driver's output is a wire; an output that differs although the
// unit's inputs do not is the unit.
std::string WiringCheck::finding() const {
  for (const Port& in : ports_) {
    if (!in.is_input || !differs(in)) continue;
    const Port* driver =
        in.driver == NoDriver ? nullptr : &ports_[static_cast<std::size_t>(in.driver)];
    if (driver && differs(*driver)) continue;
    return fmt::format(
        "{} has {:#x} instead of {:#x}, the value of {}.\nNo unit differs: the wiring of "
        "racebeam_top does.",
        in.full_name(), in.rtl.read(), in.wire.value(),
        driver ? driver->full_name() : "a pin of the chip");
  }
  std::string names;
  for (const Port& out : ports_)
    if (!out.is_input && differs(out)) names += (names.empty() ? "" : ", ") + out.full_name();
  return names + ".\nThe wiring is good so far: racebeam verify that unit.";
}

// x and y are stored without the six bits that a flight along z keeps, of the room only its j.
void WiringCheck::seek(int frame, const vec3& position, int room) {
  top_.deposit("u_sequencer.frame_q", frame);
  top_.deposit("u_navigator.g_along_z.position_x_q", position[0] >> 6);
  top_.deposit("u_navigator.g_along_z.position_y_q", position[1] >> 6);
  top_.deposit("u_navigator.g_along_z.position_z_q", position[2]);
  top_.deposit("u_navigator.g_along_z.room_j_q", room >> 4);
}

std::string WiringCheck::text() const {
  if (!found_.empty()) return found_;
  return "no port of a unit differs: the wiring of racebeam_top between the units and the pins "
         "does";
}

}  // namespace racebeam
