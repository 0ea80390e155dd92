// Waivers: coverage points that are not hit, each looked at by somebody, with the reason.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tb/scene/faults.h"
#include "tb/signoff/coverage_points.h"

namespace racebeam {

struct CoverageWaiver {
  std::vector<std::string> units;  ///< under test, not the module that the point is in
  CoveragePoint::Kind kind = CoveragePoint::Line;
  std::string module;  ///< the unit's own, or one below
  /// CoveragePoint::title() of each; "sp_q[5:3]" stands for three bits, "room_o" for all that it
  /// has.
  std::vector<std::string> points;
  /// A condition over parameters of the engine's RTL, or "": it holds for no other chip.
  std::string when;
  std::string reason;  ///< why it cannot be hit, or need not
  Place place{};
  std::string file = {};  ///< its name, where there are several
};

struct WaiversResult {
  std::vector<CoverageWaiver> waivers;  ///< usable only without faults
  Faults faults{};
};

/// Of a TOML text with tables [[waiver]]. A waiver without a reason is a fault.
WaiversResult read_coverage_waivers(std::string_view text);

/// Those of a file, or of all in a folder; "" stands for the project's,
/// tb/signoff/coverage_waivers. Throws UsageError after all faults are on stderr, MissingTool if
/// the program was installed without.
std::vector<CoverageWaiver> load_coverage_waivers(const std::string& path);
/// The project's folder.
std::string own_coverage_waivers();

/// Whether `wanted`, one of CoverageWaiver::points, stands for the point. To be asked in the order
/// of the source: `number`, 0 at first, counts the lines or branches that "#2 else: if (a)" could
/// be.
bool names_point(const std::string& wanted, const CoveragePoint& point, int& number);

}  // namespace racebeam
