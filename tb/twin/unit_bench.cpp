// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/unit_bench.h"

#include <stdexcept>
#include <utility>

#include "tb/base/simulate.h"

namespace racebeam {

namespace {

constexpr int WidestPort = 64;

template <int Bits>
class WirePin : public UnitBench::Pin {
 public:
  WirePin(const std::string& name, bool input, bool optional)
      : Pin(name, Bits, input, optional), wire_(name.c_str()) {}
  std::uint64_t value() const override { return static_cast<std::uint64_t>(wire_.read()); }
  void drive(std::uint64_t value) override {
    wire_.write(static_cast<wire_type<Bits>>(raw_bits(value, Bits)));
  }
  wire<Bits> wire_;
};

/// A random value of `bits` bits, of which `low` has the low ones.
std::uint64_t wide(std::uint64_t low, int bits, std::minstd_rand& random) {
  constexpr int LowBits = 27, MoreBits = 30;
  for (int known = LowBits; known < bits; known += MoreBits)
    low ^= static_cast<std::uint64_t>(random()) << known;
  return low;
}

}  // namespace

// Binds `port` if it is Bits wide.
template <int Bits>
bool UnitBench::add(sc_core::sc_object* port) {
  auto* in = dynamic_cast<in_port<Bits>*>(port);
  auto* out = dynamic_cast<out_port<Bits>*>(port);
  if (!in && !out) return false;
  if constexpr (Bits == 1) {
    if (in && std::string(in->basename()) == "clk_i") {
      in->bind(clk_);
      return true;
    }
  }
  const bool optional = in ? in->is_optional() : out->is_optional();
  auto pin = std::make_unique<WirePin<Bits>>(port->basename(), in != nullptr, optional);
  if (in) in->bind(pin->wire_);
  else out->bind(pin->wire_);
  order_.push_back(pin.get());
  pins_[pin->name] = std::move(pin);
  return true;
}

template <int... Less>
void UnitBench::add_any(sc_core::sc_object* port, std::integer_sequence<int, Less...>) {
  (add<Less + 1>(port) || ...);
}

UnitBench::UnitBench(sc_core::sc_module& unit, in_port<1>* beside) {
  if (beside) beside->bind(clk_);
  for (auto* child : unit.get_child_objects())
    add_any(child, std::make_integer_sequence<int, WidestPort>());
  simulate(sc_core::sc_time(1, sc_core::SC_PS));
}

UnitBench::Pin& UnitBench::operator[](const std::string& port) {
  const auto found = pins_.find(port);
  if (found == pins_.end()) throw std::out_of_range("the unit has no port '" + port + "'");
  return *found->second;
}

void UnitBench::drive(const std::string& stem, const std::string& suffix, const vec3& value) {
  for (int a = 0; a < 3; ++a)
    (*this)[stem + "_" + "xyz"[a] + suffix].drive(static_cast<std::uint64_t>(value[a]));
}

vec3 UnitBench::read(const std::string& stem, const std::string& suffix) {
  vec3 v;
  for (int a = 0; a < 3; ++a)
    v[a] = static_cast<int>((*this)[stem + "_" + "xyz"[a] + suffix].signed_value());
  return v;
}

void UnitBench::settle() { simulate(sc_core::sc_time(1, sc_core::SC_PS)); }

void UnitBench::clock(int edges) {
  if (edges < 1) return;
  edges_ += edges;
  const sc_core::sc_time after_edge = edges_ * period_ + sc_core::sc_time(1, sc_core::SC_PS);
  simulate(after_edge - sc_core::sc_time_stamp());
}

void UnitBench::shake(std::minstd_rand& random) {
  for (Pin* pin : order_) {
    if (!pin->input) continue;
    const unsigned draw = static_cast<unsigned>(random()) >> 2;
    if (pin->name == "rst_ni") pin->drive(draw % 64 != 0);
    else if (pin->name.find("reset") != std::string::npos) pin->drive(draw % 64 == 0);
    else if (draw % 4 == 0) pin->drive(wide(draw >> 2, pin->bits, random));
  }
}

void UnitBench::between_edges(std::function<void()> change) {
  sc_core::sc_spawn_options options;
  options.spawn_method();
  options.dont_initialize();
  options.set_sensitivity(&clk_.negedge_event());
  sc_core::sc_spawn(std::move(change), "change", &options);
}

void UnitBench::stir(unsigned seed) {
  between_edges([this, random = std::minstd_rand(seed)]() mutable { shake(random); });
}

}  // namespace racebeam
