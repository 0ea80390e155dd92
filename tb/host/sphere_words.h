// SphereWords: what the CPU does to its wires for a picture, clock by clock: eleven words for each
// sphere, and two for the light.
//
// A word sets one group of wires, and takes host_clocks_per_word clocks of the tracer. The last one
// takes valid away; the wires then stay as they are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "sc/sphere/sphere_host_link_core.h"

namespace racebeam {

class SphereWords {
 public:
  SphereWords(std::vector<sphere_row> spheres, int clocks_per_word)
      : spheres_(std::move(spheres)), clocks_per_word_(clocks_per_word) {}

  /// All words are sent.
  bool sent() const { return clock_ == clocks_per_word_ * words(); }
  /// The wires in the next clock.
  const sphere_host_pins& clock();
  int words() const { return static_cast<int>(spheres_.size()) * WordsOfSphere + 2; }

 private:
  static constexpr int WordsOfSphere = 11;

  void set(const sphere_row& sphere, int index, int word);

  const std::vector<sphere_row> spheres_;
  const int clocks_per_word_;
  int clock_ = 0;
  sphere_host_pins pins_;
};

}  // namespace racebeam
