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
  /// For inputs whose name begins with `start`: makes of any value one that the chip can have, or
  /// one that it is likely to have; then the others are legal too.
  struct Rule {
    std::string start;
    std::function<std::uint64_t(std::uint64_t raw)> form;
    bool likely = false;
  };
  /// The first rule that fits an input holds; without one it takes all values.
  explicit LegalInputs(std::vector<Rule> rules) : rules_(std::move(rules)) {}

  /// `raw`, or the value made of it by the rule of the input `port`.
  std::uint64_t of(const std::string& port, std::uint64_t raw) const {
    const Rule* const rule = rule_of(port);
    return rule ? rule->form(raw) : raw;
  }
  /// `raw` if the chip can have it at the input `port`, or the value made of it by the rule.
  std::uint64_t legal(const std::string& port, std::uint64_t raw) const {
    const Rule* const rule = rule_of(port);
    return rule && !rule->likely ? rule->form(raw) : raw;
  }

 private:
  const Rule* rule_of(const std::string& port) const {
    for (const Rule& rule : rules_)
      if (port.rfind(rule.start, 0) == 0) return &rule;
    return nullptr;
  }

  std::vector<Rule> rules_;
};

}  // namespace racebeam
