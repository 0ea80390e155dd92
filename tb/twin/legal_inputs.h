// Input values that a chip can have: ports are wider than the chip where a knob or a scene file may
// ask for more, and some values mean nothing.
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

class LegalInputs {
 public:
  /// For inputs whose name begins with `start`: makes of any value one that the chip can have.
  struct Rule {
    std::string start;
    std::function<std::uint64_t(std::uint64_t raw)> form;
  };
  /// The first rule that fits an input holds; without one it takes all values.
  explicit LegalInputs(std::vector<Rule> rules) : rules_(std::move(rules)) {}

  /// `raw`, or the value made of it that the chip can have at the input `port`.
  std::uint64_t of(const std::string& port, std::uint64_t raw) const {
    for (const Rule& rule : rules_)
      if (port.rfind(rule.start, 0) == 0) return rule.form(raw);
    return raw;
  }

 private:
  std::vector<Rule> rules_;
};

}  // namespace racebeam
