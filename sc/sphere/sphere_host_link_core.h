// Behaviour of sphere_host_link (sphere_host_link.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "sc/base/probe.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_scene.h"
#include "sc/sphere/sphere_table_core.h"

namespace racebeam {

/// A register that is shifted, its new bit from two others: more than HostPatience values until it
/// is 0 again. It is smaller than a counter, and every mistake in it moves its end.
constexpr int PatienceBits = 17;
constexpr unsigned next_patience(unsigned patience) {
  const unsigned odd = patience >> 16 ^ patience >> 13;
  return (patience << 1 | (~odd & 1)) & ((1u << PatienceBits) - 1);
}
constexpr unsigned last_patience() {
  unsigned patience = 0;
  for (int n = 1; n < HostPatience; ++n) patience = next_patience(patience);
  return patience;
}

/// The wires from the CPU.
struct sphere_host_pins {
  int sphere = 0, color = 0;
  int x1 = 0, y1 = 0, z1 = 0;  ///< signed
  int reflect = 0, radius = 0, r2 = 0, r_inv = 0;
  bool valid = false;
};

struct sphere_host_link_core {
  static constexpr unsigned LastPatience = last_patience();

  bool waiting_q = false;   // valid is 1 and not taken
  bool taken_q = false;     // valid is 1 and was taken
  bool answered_q = false;  // a CPU sent something
  unsigned patience_q = 0;  // as far as next_patience() has gone
  bool expired_q = false;   // no CPU came
  int count_q = 0;          // entries of this picture
  bool loaded_q = false, fault_q = false;
  sphere_table_core::inputs write_q{};

  struct inputs {
    bool rst_n;
    sphere_host_pins cpu;
    vec3 light;
    bool scene, host;
  };

  /// A clock with these inputs changes nothing; of them the reset, valid and host count.
  bool idle(const inputs& in) const {
    return in.rst_n && !in.host && !loaded_q && !fault_q && !write_q.write &&
           (in.cpu.valid ? taken_q || waiting_q : !taken_q && !waiting_q);
  }
  void clock(const inputs& in, const sphere_knobs& k) {
    if (!in.rst_n) {
      *this = {};
      return;
    }
    const bool listens = in.host && !loaded_q;
    const bool edge = in.cpu.valid && !taken_q;
    const bool given_up = waiting_q && !in.cpu.valid;
    fault_q = given_up;
    write_q.write = false;
    if (loaded_q) count_q = 0;
    loaded_q = false;
    if (listens && edge) {
      answered_q = true;
      take(in, in.cpu.sphere >> 4, row_of(in.cpu), in.cpu.sphere & 15, k);
    } else if (listens && !answered_q && expired_q) {
      const auto& spheres = builtin_spheres(in.scene);
      const int number = static_cast<int>(spheres.size());
      const int last = std::min(number, k.table_entries - 1);
      take(in, last, spheres[std::min(count_q, number - 1)], count_q, k);
    }
    if (listens) {
      expired_q = expired_q || patience_q == LastPatience;
      patience_q = next_patience(patience_q);
    }
    taken_q = in.cpu.valid && (taken_q || listens);
    waiting_q = in.cpu.valid && !taken_q;
  }

  /// Calls visit(name, bits, read) for each register but the fields, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("waiting_q", 1, [this] { return waiting_q; });
    visit("taken_q", 1, [this] { return taken_q; });
    visit("answered_q", 1, [this] { return answered_q; });
    visit("patience_q", PatienceBits, [this] { return patience_q; });
    visit("expired_q", 1, [this] { return expired_q; });
    visit("count_q", SphereIndexBits, [this] { return count_q; });
    visit("loaded_q", 1, [this] { return loaded_q; });
    visit("fault_q", 1, [this] { return fault_q; });
    visit("write_q", 1, [this] { return write_q.write; });
    visit("index_q", SphereIndexBits, [this] { return write_q.index; });
    visit("last_q", SphereIndexBits, [this] { return write_q.last; });
  }

 private:
  static sphere_row row_of(const sphere_host_pins& cpu) {
    return {{cpu.x1, cpu.y1, cpu.z1},
            cpu.radius,
            cpu.r2,
            cpu.r_inv,
            cpu.reflect,
            {cpu.color >> 10 & 31, cpu.color >> 5 & 31, cpu.color & 31},
            bit_of(cpu.color, 15)};
  }
  void take(const inputs& in, int number, const sphere_row& sphere, int index,
            const sphere_knobs& k) {
    const int last = std::min(number, k.table_entries - 1);
    if (count_q >= last) {
      write_q = {true, last, last, sphere_row::light(in.light)};
      loaded_q = true;
      if (number > last) fault_q = true;
    } else {
      if (index <= last) write_q = {true, index, last, sphere};
      else fault_q = true;
      ++count_q;
    }
  }
};

}  // namespace racebeam
