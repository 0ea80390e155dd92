// wire: what joins the ports of racebeam units, a SystemC signal of exact width.
//
// What lies elsewhere, such as the inputs of verilated RTL, follows a wire when that changes,
// instead of asking it in each clock; and drives it without a virtual call.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <systemc>
#include <type_traits>
#include <utility>

namespace racebeam {

/// The SystemC type that carries `Bits` bits.
template <int Bits>
using wire_type = std::conditional_t<Bits == 1, bool, sc_dt::sc_uint<Bits>>;

/// A place that has what a wire has, as soon as that changes. It lives as long as the wire is
/// written to.
struct wire_follower {
  void* place = nullptr;  ///< of 1, 2, 4 or 8 bytes, the fewest that hold the wire's bits
  std::uint32_t* moved = nullptr;
  std::uint32_t bit = 0;               ///< set in `*moved` with each change
  sc_core::sc_event* wakes = nullptr;  ///< notified of each change; nullptr: none
  wire_follower* next = nullptr;

  /// Whether that is another value.
  template <class Place>
  void take(Place value) {
    auto& in = *static_cast<Place*>(place);
    if (in == value) return;
    in = value;
    *moved |= bit;
    if (wakes) wakes->notify(sc_core::SC_ZERO_TIME);
  }
};

/// The type of a follower's place.
template <int Bits>
using follower_place = std::conditional_t<
    (Bits <= 8), std::uint8_t,
    std::conditional_t<(Bits <= 16), std::uint16_t,
                       std::conditional_t<(Bits <= 32), std::uint32_t, std::uint64_t>>>;

/// A wire whose width is not in the type.
class any_wire {
 public:
  /// The low bits of `value`, from the next update on, as by write(). No virtual call.
  void drive(std::uint64_t value) {
    driven_ = value;
    is_driven_ = true;
    channel_.request_update();
  }
  void add(wire_follower& follower) {
    follower.next = followers_;
    followers_ = &follower;
  }

 protected:
  explicit any_wire(sc_core::sc_prim_channel& channel) : channel_(channel) {}
  virtual ~any_wire() = default;

  wire_follower* followers_ = nullptr;
  std::uint64_t driven_ = 0;
  bool is_driven_ = false;

 private:
  sc_core::sc_prim_channel& channel_;
};

/// A wire with one driver; `Bits` wide.
template <int Bits>
class wire : public sc_core::sc_signal<wire_type<Bits>, sc_core::SC_UNCHECKED_WRITERS>,
             public any_wire {
  using signal = sc_core::sc_signal<wire_type<Bits>, sc_core::SC_UNCHECKED_WRITERS>;

 public:
  template <class... Options>
  explicit wire(const Options&... options)
      : signal(options...), any_wire(static_cast<signal&>(*this)) {}

 protected:
  void update() override {
    if (std::exchange(is_driven_, false)) this->m_new_val = static_cast<wire_type<Bits>>(driven_);
    signal::update();
    for (wire_follower* follower = followers_; follower; follower = follower->next)
      follower->take(static_cast<follower_place<Bits>>(this->m_cur_val));
  }
};

}  // namespace racebeam
