// KnobCondition: the `where` of a sweep, such as `fifo_entries <= 8 && bisection == pow2`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "tb/base/expression.h"

namespace racebeam {

class KnobCondition {
 public:
  /// Throws UsageError: no such knob, no such value, not an expression.
  KnobCondition(const engine& of, const std::string& text);

  bool holds(const knob_values& k);

 private:
  std::vector<double> values_;  // by row of the table; their places are known to the expression
  Expression expression_;
};

}  // namespace racebeam
