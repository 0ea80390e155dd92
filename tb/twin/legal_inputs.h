// Input values that the chip's widths hold: ports are wider than the chip where a knob or a scene
// file may ask for more.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/knobs.h"

namespace racebeam {

class LegalInputs {
 public:
  /// For a chip with the knobs `k`.
  explicit LegalInputs(const knobs& k);

  /// `raw`, at least 0, or the value made of it that the chip can have at the input `port`.
  int of(const std::string& port, int raw) const;

 private:
  enum Form { Unsigned, Signed, Below, OneBit, Room, Line };
  /// Inputs whose port is wider than the chip's value, or that have fewer values than bits.
  struct Rule {
    const char* start;  ///< of the port's name
    Form form;
    int size;  ///< bits, or number of values
  };

  static int formed(const Rule& rule, int raw);

  std::vector<Rule> rules_;  ///< the first that fits holds
};

}  // namespace racebeam
