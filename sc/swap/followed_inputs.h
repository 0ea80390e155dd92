// followed_inputs: inputs of verilated RTL have what the wires of the chip have, as soon as that
// changes.
//
// A wire tells its followers of each change, so a clock does not ask all wires, which lie far
// apart, for what few of them have changed.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <deque>

#include "sc/base/unit.h"
#include "sc/swap/rtl_model.h"
#include "sc/swap/wire_place.h"

namespace racebeam {

class followed_inputs {
 public:
  /// Of one instance; both live as long as the chip is simulated.
  explicit followed_inputs(const rtl_model& model) : moved_(model.moved) {}

  /// From the end of elaboration on; the input counts as moved. `moved`: notified when it has and
  /// reaches an output before the next edge; nullptr: nobody waits. Throws RtlError: no wire.
  void follow(any_port& pin, const rtl_port& rtl, sc_core::sc_event* moved) {
    input& in = inputs_.emplace_back();
    in.wire = pin.contents();
    in.bytes = static_cast<std::size_t>(rtl.bytes);
    in.follower = {rtl.place, moved_, rtl.moved, rtl.moved == Quiet ? nullptr : moved};
    wire_of(pin).add(in.follower);
    take(in);
  }
  /// RTL had other inputs in the meantime: all have what their wires have, and count as moved.
  void take_all() {
    for (input& in : inputs_) take(in);
  }

  /// Whether an input has moved that reaches an output before the next edge; whether another has.
  bool prompt_moved() const { return (*moved_ & ~Quiet) != 0; }
  bool quiet_moved() const { return (*moved_ & Quiet) != 0; }

 private:
  static constexpr std::uint32_t Quiet = std::uint32_t{1} << RtlQuiet;
  // In one line of the cache.
  struct alignas(64) input {
    wire_follower follower;
    wire_contents wire;
    std::size_t bytes = 0;
  };
  // The machine's bytes begin with the lowest.
  static void take(input& in) {
    const std::uint64_t bits = in.wire.value();
    std::memcpy(in.follower.place, &bits, in.bytes);
    *in.follower.moved |= in.follower.bit;
  }

  std::uint32_t* const moved_;  // of the model
  std::deque<input> inputs_;    // which stay in their places
};

}  // namespace racebeam
