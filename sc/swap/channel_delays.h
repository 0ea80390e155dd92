// channel_delays: channel_delay units in the wires between the units of a chip. Units know nothing
// of them, and a chip without a plan has none.
//
// What    each channel of the plan has one channel_delay: what the unit that takes sees comes out
//         of it, and the units that offer see its answer. The wires of the chip stay those of the
//         units that drive them; late_<port> are what units see instead.
// Cycles  as sc/base/channel_delay.h has it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sc/base/channel_delay.h"
#include "sc/base/delay_plan.h"
#include "sc/base/unit.h"

namespace racebeam {

class channel_delays {
 public:
  /// In the constructor of `chip`, whose clock it is: nullptr if no planned_delays live.
  static std::unique_ptr<channel_delays> make(const sc_core::sc_module& chip, in_port<1>& clk);
  /// Of a chip that was made; nullptr: it has none.
  static channel_delays* of(const sc_core::sc_module& chip);

  ~channel_delays();
  channel_delays(const channel_delays&) = delete;
  channel_delays& operator=(const channel_delays&) = delete;

  /// What the input `port` is to be bound to instead of `from`: `from` itself if no channel has it.
  template <int Bits>
  wire<Bits>& before(const in_port<Bits>& port, wire<Bits>& from) {
    const auto [of, role] = find(port);
    if (!of) return from;
    const auto late = std::make_shared<wire<Bits>>(late_name(port).c_str());
    wire<Bits>& to = *late;
    wires_.push_back(late);
    if constexpr (Bits == 1) {
      if (role != Data) {
        join(*of, role, from, to);
        return to;
      }
    }
    of->data.push_back({[&from] { return contents_of<Bits>(from.read()).value(); },
                        [&to](std::uint64_t value) { to.write(wire_type<Bits>(value)); },
                        std::vector<std::uint64_t>(static_cast<std::size_t>(of->core.capacity))});
    return to;
  }

  /// Ports of the plan that the chip has not, by now.
  std::vector<std::string> missing() const;
  /// Something is in the registers.
  bool busy() const { return busy_.read(); }

 private:
  enum port_role { Valid, Data, Ack, Ready };
  struct datum {
    std::function<std::uint64_t()> read;
    std::function<void(std::uint64_t)> write;
    std::vector<std::uint64_t> entries;
  };
  struct delay {
    const delay_plan::channel* row;
    channel_delay_core core;
    const wire<1>* offered = nullptr;
    wire<1>* offer = nullptr;
    const wire<1>* taken = nullptr;  // nullptr: always
    std::vector<wire<1>*> acks{}, readies{};
    std::vector<datum> data{};
    const wire<1>* clear = nullptr;  // nullptr: the reset
    void drive();
    void answer();
  };
  struct found_port {
    delay* of;
    port_role role;
  };

  channel_delays(const sc_core::sc_module& chip, const delay_plan& plan, in_port<1>& clk);
  found_port find(const sc_core::sc_object& port);
  void join(delay& of, port_role role, const wire<1>& from, wire<1>& to);
  std::string path_of(const sc_core::sc_object& port) const;
  std::string late_name(const sc_core::sc_object& port) const;
  bool cleared(const delay& one) const;
  void tick();

  const sc_core::sc_module& chip_;
  const delay_plan plan_;
  std::vector<std::unique_ptr<delay>> delays_;
  std::vector<std::shared_ptr<void>> wires_;
  std::vector<std::string> found_;  // ports, as the plan names them
  const in_port<1>* reset_ = nullptr;
  wire<1> busy_{"delays_busy"};  // a wire, as who looks at an edge wants the clock that ends
};

/// While it lives, chips that are made have channels with registers as its plan says. One at a
/// time; with nullptr it does nothing.
class planned_delays {
 public:
  explicit planned_delays(std::shared_ptr<const delay_plan> plan);
  ~planned_delays();
  planned_delays(const planned_delays&) = delete;
  planned_delays& operator=(const planned_delays&) = delete;
};

/// The wire that an input of a unit is to be bound to; `delays` may be nullptr.
template <int Bits>
wire<Bits>& delayed(const std::unique_ptr<channel_delays>& delays, const in_port<Bits>& port,
                    wire<Bits>& from) {
  return delays ? delays->before(port, from) : from;
}

}  // namespace racebeam
