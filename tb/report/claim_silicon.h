// Claims about silicon: cells and flip-flops of units and of the chip, by yosys.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/report/claim_figures.h"
#include "tb/sweep/silicon.h"
#include "tb/sweep/store_caches.h"

namespace racebeam {

class ClaimSilicon {
 public:
  /// What is synthesised is kept in `cache`, which outlives this.
  explicit ClaimSilicon(UnitCache& cache);

  /// A chip that figures will be asked of.
  void want(const SiliconFigure& figure, const knob_values& k);
  /// Synthesises what is not there. Throws Interrupted.
  void measure(int jobs);
  /// Nothing, and then why() says it.
  std::optional<double> value(const SiliconFigure& figure, const knob_values& k) const;
  std::string why(const SiliconFigure& figure, const knob_values& k) const;

 private:
  std::vector<UnitParameters> units_of(const SiliconFigure& figure, const knob_values& k) const;

  UnitCache& cache_;
  std::optional<Silicon> silicon_{};
  std::string missing_;  ///< what is not installed
  std::map<std::string, UnitParameters> wanted_;
  std::map<std::string, std::string> faults_;  ///< by hash
};

}  // namespace racebeam
