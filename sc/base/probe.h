// Probes: the registers of a unit, and the signals inside its RTL, for waveforms.
//
// Whoever looks asks once for all of them and reads each when its clock has settled. A run that
// nobody looks into pays nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace racebeam {

/// One value inside a unit.
struct probe {
  std::string name;                     ///< as in the RTL: "i1_q", "g_axis[0].dr1_q", "faces_q[3]"
  int bits;                             ///< 1..64
  std::function<std::uint64_t()> read;  ///< the low `bits` bits of it
};

/// A module with something to show besides its ports.
class probed {
 public:
  virtual ~probed() = default;
  /// What there is to read as long as the module lives.
  virtual std::vector<probe> probes() const = 0;
  /// From the next line on all of it follows every clock, also what the module needs for nobody
  /// else and would sleep through.
  virtual void watch() {}
};

/// Bits that number `count` things: $clog2.
constexpr int count_bits(int count) {
  int bits = 0;
  while ((1 << bits) < count) ++bits;
  return bits;
}

/// An element of an array, as the RTL calls it.
inline std::string element(const char* name, int index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

/// The registers that a core names to `each_register(visit, setting)`; the core must stay where it
/// is. `setting`: what their widths follow, such as the knobs.
template <class Core, class... Setting>
std::vector<probe> registers_of(const Core& core, const Setting&... setting) {
  std::vector<probe> all;
  core.each_register(
      [&all](std::string name, int bits, auto read) {
        const std::uint64_t mask = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
        all.push_back({std::move(name), bits, [read, mask] {
                         return static_cast<std::uint64_t>(static_cast<std::int64_t>(read())) &
                                mask;
                       }});
      },
      setting...);
  return all;
}

/// Bits of all of them.
template <class Core, class... Setting>
std::uint64_t register_bits(const Core& core, const Setting&... setting) {
  std::uint64_t sum = 0;
  for (const probe& one : registers_of(core, setting...)) sum += static_cast<unsigned>(one.bits);
  return sum;
}

}  // namespace racebeam
