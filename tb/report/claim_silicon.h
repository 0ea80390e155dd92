// Claims about silicon: cells and flip-flops of units and of the chip, by yosys, and its longest
// path.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/report/claim_figures.h"
#include "tb/sweep/chip_mapping.h"
#include "tb/sweep/store.h"

namespace racebeam {

class ClaimSilicon {
 public:
  /// What is synthesised is kept in `store`, which outlives this.
  explicit ClaimSilicon(Store& store);

  /// A chip that figures will be asked of.
  void want(const SiliconFigure& figure, const knob_values& k);
  /// Synthesises what is not there. Throws Interrupted.
  void measure(int jobs);
  /// Nothing, and then why() says it.
  std::optional<double> value(const SiliconFigure& figure, const knob_values& k) const;
  std::string why(const SiliconFigure& figure, const knob_values& k) const;

 private:
  void want_path(const knob_values& k);
  /// Throws NoSilicon.
  std::string why_no_path(const knob_values& k) const;
  std::vector<UnitParameters> units_of(const SiliconFigure& figure, const knob_values& k) const;

  UnitCache& cache_;
  ChipCache& chips_;
  std::optional<Silicon> silicon_{};
  std::optional<Technology> technology_{};  ///< once a path is wanted
  std::string missing_, no_technology_;     ///< what is not installed
  std::map<std::string, UnitParameters> wanted_;
  std::map<std::string, ChipWanted> wanted_chips_;
  std::map<std::string, std::string> faults_;  ///< by hash
};

}  // namespace racebeam
