// Ports of racebeam units: exact widths on top of SystemC's ports.
//
// A 1-bit port is `bool`, a wider one `sc_uint<Bits>`, up to 64 bits; signed values cross a port as
// raw two's complement. A unit reads ports of up to 31 bits as int, wider ones as 64 bits. An input
// reads the channel's value through a reference taken once, at the end of elaboration; an output
// writes only what changed. Both keep the kernel out of the hot path. RTL written before a knob
// brought a port fits without that port.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <systemc>
#include <type_traits>
#include <vector>

#include "sc/base/fixed_point.h"
#include "sc/base/wire.h"

namespace racebeam {

/// What the raw bits, and the signed value, of a port are read as.
template <int Bits>
using raw_value = std::conditional_t<(Bits < 32), int, std::uint64_t>;
template <int Bits>
using signed_number = std::conditional_t<(Bits < 32), int, std::int64_t>;

/// What a wire carries, read without a virtual call; one of the pointers is nullptr.
struct wire_contents {
  const bool* bit = nullptr;
  const sc_dt::sc_uint_base* word = nullptr;

  /// The raw bits.
  std::uint64_t value() const { return bit ? *bit : word->value(); }
};

/// A port whose width is not in the type: for what treats all ports alike.
class any_port {
 public:
  virtual ~any_port() = default;
  virtual const char* port_name() const = 0;
  virtual int bits() const = 0;
  virtual bool is_input() const = 0;
  /// RTL may do without it.
  virtual bool is_optional() const = 0;
  /// Its wire; from the end of elaboration on.
  virtual wire_contents contents() const = 0;
  /// Drives an output.
  virtual void drive_wire(std::uint64_t value) = 0;
};

/// Marks a port that only some setting of a knob needs.
struct optional_port {};
constexpr optional_port OfKnob;

template <int Bits>
wire_contents contents_of(const wire_type<Bits>& value) {
  if constexpr (Bits == 1) return {&value, nullptr};
  else return {nullptr, &value};
}

/// All ports of a module, in the order of declaration.
std::vector<any_port*> ports_of(const sc_core::sc_module& module);

/// Input port of `Bits` bits.
template <int Bits>
class in_port final : public sc_core::sc_in<wire_type<Bits>>, public any_port {
 public:
  using sc_core::sc_in<wire_type<Bits>>::sc_in;
  in_port(const char* name, optional_port)
      : sc_core::sc_in<wire_type<Bits>>(name), optional_(true) {}

  const char* port_name() const override { return this->basename(); }
  int bits() const override { return Bits; }
  bool is_input() const override { return true; }
  bool is_optional() const override { return optional_; }
  wire_contents contents() const override { return contents_of<Bits>(*channel_value_); }
  void drive_wire(std::uint64_t) override {}

  /// The raw bits.
  raw_value<Bits> value() const {
    if constexpr (Bits == 1) return *channel_value_;
    else return static_cast<raw_value<Bits>>(channel_value_->value());
  }
  /// The bits as a signed number.
  signed_number<Bits> signed_value() const {
    if constexpr (Bits < 32) return wrap_signed(value(), Bits);
    else return signed_bits(value(), Bits);
  }

 protected:
  void end_of_elaboration() override {
    sc_core::sc_in<wire_type<Bits>>::end_of_elaboration();
    channel_value_ = &(*this)->read();
  }

 private:
  const wire_type<Bits>* channel_value_ = nullptr;
  const bool optional_ = false;
};

/// Output port of `Bits` bits.
template <int Bits>
class out_port final : public sc_core::sc_out<wire_type<Bits>>, public any_port {
 public:
  using sc_core::sc_out<wire_type<Bits>>::sc_out;
  out_port(const char* name, optional_port)
      : sc_core::sc_out<wire_type<Bits>>(name), optional_(true) {}

  const char* port_name() const override { return this->basename(); }
  int bits() const override { return Bits; }
  bool is_input() const override { return false; }
  bool is_optional() const override { return optional_; }
  wire_contents contents() const override { return contents_of<Bits>((*this)->read()); }
  void drive_wire(std::uint64_t value) override { drive(static_cast<raw_value<Bits>>(value)); }

  /// Drives the low `Bits` bits of `value`.
  void drive(raw_value<Bits> value) {
    constexpr auto mask = static_cast<raw_value<Bits>>(raw_bits(~std::uint64_t{0}, Bits));
    const raw_value<Bits> raw = value & mask;
    if (raw == driven_) return;
    driven_ = raw;
    (*this)->write(static_cast<wire_type<Bits>>(raw));
  }

 private:
  raw_value<Bits> driven_ = 0;
  const bool optional_ = false;
};

/// One object per axis, named `<stem>_x<suffix>`, `_y`, `_z`.
template <class Object>
struct axes {
  Object x, y, z;

  explicit axes(const std::string& stem, const std::string& suffix = "")
      : x((stem + "_x" + suffix).c_str()),
        y((stem + "_y" + suffix).c_str()),
        z((stem + "_z" + suffix).c_str()) {}

  /// Binds the ports of three axes to three wires.
  template <class Channels>
  void bind(Channels& to) {
    x.bind(to.x);
    y.bind(to.y);
    z.bind(to.z);
  }
};

template <int Bits>
struct axes_in : axes<in_port<Bits>> {
  using axes<in_port<Bits>>::axes;
  static_assert(Bits <= 32, "an axis is an int");
  vec3 signed_value() const {
    return {static_cast<int>(this->x.signed_value()), static_cast<int>(this->y.signed_value()),
            static_cast<int>(this->z.signed_value())};
  }
};

template <int Bits>
struct axes_out : axes<out_port<Bits>> {
  using axes<out_port<Bits>>::axes;
  void drive(const vec3& v) {
    this->x.drive(static_cast<raw_value<Bits>>(v[0]));
    this->y.drive(static_cast<raw_value<Bits>>(v[1]));
    this->z.drive(static_cast<raw_value<Bits>>(v[2]));
  }
};

template <int Bits>
using axes_wire = axes<wire<Bits>>;

}  // namespace racebeam
