// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_words.h"

namespace racebeam {

const sphere_host_pins& SphereWords::clock() {
  if (sent()) return pins_;
  const int word = clock_++ / clocks_per_word_;
  const int index = word / WordsOfSphere;
  if (index < static_cast<int>(spheres_.size()))
    set(spheres_[static_cast<std::size_t>(index)], index, word % WordsOfSphere);
  else pins_.valid = word % WordsOfSphere == 0;
  return pins_;
}

void SphereWords::set(const sphere_row& sphere, int index, int word) {
  switch (word) {
    case 0: pins_.sphere = static_cast<int>(spheres_.size()) << 4 | index; break;
    case 1: pins_.color = sphere.color_word(); break;
    case 2: pins_.x1 = sphere.centre[0]; break;
    case 3: pins_.y1 = sphere.centre[1]; break;
    case 4: pins_.z1 = sphere.centre[2]; break;
    case 5: pins_.reflect = sphere.reflect; break;
    case 6: pins_.radius = sphere.radius; break;
    case 7: pins_.r2 = sphere.radius2; break;
    case 8: pins_.r_inv = sphere.inverse; break;
    default: pins_.valid = word == 9; break;
  }
}

}  // namespace racebeam
