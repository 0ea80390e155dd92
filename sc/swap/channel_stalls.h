// channel_stalls: filters in the wires between the units of a chip, which hold channels back in
// bursts. Units know nothing of them, and a chip without a plan has none.
//
// What    each channel of the plan has a wire stall_<channel>. While it is 1, the ports of the
//         channel see what the plan says instead of their wires: valid and ack alike, in the same
//         clock. A burst begins and goes on with the probabilities of the plan.
// Cycles  a filter is combinational; stalls change with the clock's rising edge.
// Reset   begin(): the stalls that follow are a function of seed, channel, place and clock only.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sc/base/stall_plan.h"
#include "sc/base/unit.h"

namespace racebeam {

class channel_stalls {
 public:
  /// In the constructor of `chip`, whose clock it is: nullptr if no planned_stalls live.
  static std::unique_ptr<channel_stalls> make(const sc_core::sc_module& chip, in_port<1>& clk);
  /// Of a chip that was made; nullptr: it has none.
  static channel_stalls* of(const sc_core::sc_module& chip);

  ~channel_stalls();
  channel_stalls(const channel_stalls&) = delete;
  channel_stalls& operator=(const channel_stalls&) = delete;

  /// What the input `port` is to be bound to instead of `from`: `from` itself if no channel has it.
  wire<1>& before(const in_port<1>& port, wire<1>& from);
  /// The same of an output that drives `to`.
  wire<1>& behind(const out_port<1>& port, wire<1>& to);

  /// Stalls begin anew, from the next rising edge on: at a frame, such as `place`.
  void begin(std::uint64_t place);
  /// From the next begin() on another seed than that of the plan.
  void reseed(std::uint64_t seed);
  /// From the next begin() on no stalls, until reseed().
  void rest() { resting_ = true; }
  const stall_plan& plan() const { return plan_; }

  /// Ports of the plan that the chip has not, by now.
  std::vector<std::string> missing() const;
  /// Clocks with a stall so far, of all channels.
  std::uint64_t stalled_clocks() const { return stalled_; }

 private:
  channel_stalls(const sc_core::sc_module& chip, const stall_plan& plan, in_port<1>& clk);

  struct channel {
    std::string name;
    std::unique_ptr<wire<1>> stall;
    const wire<1>* unless;
    std::uint64_t state;
    bool holds() const { return stall->read() && !(unless && unless->read()); }
  };
  struct held_port {
    const channel* of;
    bool held;
  };

  std::vector<held_port> held(const std::string& port);
  void filter(const std::string& name, const wire<1>& from, wire<1>& to,
              const std::vector<held_port>& by);
  channel& channel_of(const stall_plan::channel& row, const std::string& index);
  const wire<1>* wire_named(const std::string& name) const;
  std::string path_of(const sc_core::sc_object& port) const;
  void tick();

  const sc_core::sc_module& chip_;
  stall_plan plan_;
  std::vector<std::unique_ptr<channel>> channels_;
  std::vector<std::unique_ptr<wire<1>>> wires_;
  std::vector<std::string> found_;  // ports, as the plan names them
  bool resting_ = false, begun_ = false;
  std::uint64_t stalled_ = 0;
};

/// While it lives, chips that are made have channels that stall as its plan says. One at a time;
/// with nullptr it does nothing.
class planned_stalls {
 public:
  explicit planned_stalls(std::shared_ptr<const stall_plan> plan);
  ~planned_stalls();
  planned_stalls(const planned_stalls&) = delete;
  planned_stalls& operator=(const planned_stalls&) = delete;
};

/// Binds an input of a unit to its wire; `stalls` may be nullptr.
inline void bind_channel(const std::unique_ptr<channel_stalls>& stalls, in_port<1>& port,
                         wire<1>& from) {
  port(stalls ? stalls->before(port, from) : from);
}
/// The same of an output.
inline void bind_channel(const std::unique_ptr<channel_stalls>& stalls, out_port<1>& port,
                         wire<1>& to) {
  port(stalls ? stalls->behind(port, to) : to);
}

}  // namespace racebeam
