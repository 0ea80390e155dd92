// Coverage of a unit under what `racebeam verify` drives it with alone: lines, branches and
// toggling bits of its RTL, and the crosses that its model has seen.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/signoff/check_result.h"
#include "tb/signoff/coverage_points.h"
#include "tb/signoff/coverage_waivers.h"
#include "tb/signoff/functional_points.h"
#include "tb/signoff/parameter_condition.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

struct CoverageOptions {
  std::uint64_t random = 100'000;  ///< clocks of random traffic; the walk is as long as it is
  unsigned seed = 1;
  std::string rtl;      ///< "" for the unit's own; else a user's, as `verify UNIT=` takes it
  std::string waivers;  ///< a TOML file; "" stands for the project's
};

/// What was counted.
struct UnitCoverage {
  std::vector<CoveragePoint> points;
  std::vector<bool> constant;  ///< by point: shown to be constant in this chip
  /// By cross of functional_crosses(), in order.
  std::vector<std::vector<std::uint64_t>> crosses;
  std::uint64_t clocks = 0;
  RtlParameters parameters;  ///< of all units, for conditions of waivers and crosses
};

/// Runs the unit in processes of its own. Throws RtlError, RtlFault, MissingTool, Interrupted.
UnitCoverage measure_coverage(const UnitUnderTest& dut, const CoverageOptions& options);

/// Good if all points are hit, shown to be constant, or waived, and all crosses that can be were
/// seen; a waiver of `waivers` for this unit is a fault if one of its points is hit, constant
/// anyhow, or not there.
CheckResult judge_coverage(const std::string& unit, const UnitCoverage& coverage,
                           const std::vector<FunctionalCross>& crosses,
                           const std::vector<CoverageWaiver>& waivers);

/// Both. Undecided without Verilator or yosys, when interrupted, and for a plug-in, whose source
/// nobody has. Throws UsageError for a file of waivers that cannot be read.
CheckResult sign_off_coverage(const UnitUnderTest& dut, const CoverageOptions& options);

}  // namespace racebeam
