// One unit alone on the bench: every port gets a wire, reached by the port's name.
//
// Works for any module whose ports are in_port and out_port, so that a test needs no code for the
// pins of a unit. A missing or misspelt port name throws.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "sc/base/unit.h"

namespace racebeam {

class UnitBench {
 public:
  /// The wire at a port.
  class Pin {
   public:
    Pin(std::string name, int bits, bool input, bool optional)
        : name(std::move(name)), bits(bits), input(input), optional(optional) {}
    virtual ~Pin() = default;
    /// Raw bits, as settled.
    virtual std::uint64_t value() const = 0;
    /// Raw bits to an input; seen by the unit from the next settle() or clock() on.
    virtual void drive(std::uint64_t value) = 0;
    std::int64_t signed_value() const { return signed_bits(value(), bits); }

    const std::string name;
    const int bits;
    const bool input, optional;  ///< optional: RTL may do without it
  };

  /// Binds all ports of `unit`; ports named clk_i get the clock. Reset pins start at 0 (active).
  /// `beside` gets the clock too: of a checker. Only one bench and nothing else of SystemC may
  /// exist in the process.
  explicit UnitBench(sc_core::sc_module& unit, in_port<1>* beside = nullptr);

  /// The pin of a port. Throws std::out_of_range naming the port.
  Pin& operator[](const std::string& port);
  /// All pins but the clock, in the order of declaration.
  const std::vector<Pin*>& pins() const { return order_; }

  /// Sets a per-axis input (`stem` + _x, _y, _z + `suffix`), and reads such an output (signed).
  void drive(const std::string& stem, const std::string& suffix, const vec3& value);
  vec3 read(const std::string& stem, const std::string& suffix = "_o");

  /// Lets combinational outputs follow the inputs, without a clock edge.
  void settle();
  /// One rising edge: registers take what the settled inputs say; then settles.
  void clock(int edges = 1);

  /// New random values on the inputs: reset pins are active once in 64 times, other inputs change
  /// once in four.
  void shake(std::minstd_rand& random);
  /// From now on calls `change` between the edges, where it may drive inputs.
  void between_edges(std::function<void()> change);
  /// From now on shakes between the edges.
  void stir(unsigned seed);

 private:
  // A settle() takes 1 ps of it: there is room for any number of them.
  const sc_core::sc_time period_{1, sc_core::SC_MS};

  template <int Bits>
  bool add(sc_core::sc_object* port);
  template <int... Less>
  void add_any(sc_core::sc_object* port, std::integer_sequence<int, Less...>);

  sc_core::sc_clock clk_{"clk", period_, 0.5, period_};
  std::map<std::string, std::unique_ptr<Pin>> pins_;
  std::vector<Pin*> order_;
  int edges_ = 0;
};

}  // namespace racebeam
