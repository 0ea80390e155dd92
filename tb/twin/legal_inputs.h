// Input values that a chip can have: ports are wider than the chip where a knob or a scene file may
// ask for more, and some values mean nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace racebeam {

class LegalInputs {
 public:
  /// For inputs whose name begins with `start`: makes of any value, at least 0, one that the chip
  /// can have.
  struct Rule {
    std::string start;
    std::function<int(int raw)> form;
  };
  /// The first rule that fits an input holds; without one it takes all values.
  explicit LegalInputs(std::vector<Rule> rules) : rules_(std::move(rules)) {}

  /// `raw`, at least 0, or the value made of it that the chip can have at the input `port`.
  int of(const std::string& port, int raw) const {
    for (const Rule& rule : rules_)
      if (port.rfind(rule.start, 0) == 0) return rule.form(raw);
    return raw;
  }

 private:
  std::vector<Rule> rules_;
};

}  // namespace racebeam
