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

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"

namespace racebeam {

class LegalInputs {
 public:
  /// For inputs whose name begins with `start`: makes of any value one that the chip can have, and
  /// leaves that as it is; or one that it is likely to have, then the others are legal too.
  struct Rule {
    std::string start;
    std::function<std::uint64_t(std::uint64_t raw)> form;
    bool likely = false;
  };
  /// The first rule that fits an input holds; without one it takes all values.
  explicit LegalInputs(std::vector<Rule> rules) : rules_(std::move(rules)) {}

  /// These, but first the rule `one`.
  LegalInputs preceded_by(Rule one) const {
    LegalInputs others = *this;
    others.rules_.insert(others.rules_.begin(), std::move(one));
    return others;
  }

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

/// Of an input `y_i` that is a scan line: signed, 10 bits, FirstLine to LastLine.
inline LegalInputs::Rule scan_line() {
  return {"y_i", [](std::uint64_t raw) {
            constexpr int LineBits = 10;
            const std::int64_t line = signed_bits(raw, LineBits);
            const bool is_line = line >= FirstLine && line <= LastLine;
            return is_line ? raw : static_cast<std::uint64_t>(FirstLine) + raw % FrameLines;
          }};
}

}  // namespace racebeam
