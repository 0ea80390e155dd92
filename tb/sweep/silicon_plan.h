// SiliconPlan: the syntheses that the points of a sweep need, and the sums over their units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/sweep/silicon.h"
#include "tb/sweep/synthesis.h"

namespace racebeam {

/// The chip of a point without its sound, or why there are no figures of it.
struct PointSilicon {
  std::int64_t flip_flops = 0, cells = 0;
  std::string fault;  ///< "": there are figures
};

class SiliconPlan {
 public:
  /// `stored`: what is known of a unit by its hash, such as UnitCache::find.
  SiliconPlan(const Silicon& silicon,
              std::function<std::optional<UnitSilicon>(const std::string& hash)> stored);

  /// A point of the sweep. One without silicon adds nothing.
  void want(const knob_values& k);
  /// Units that are neither stored nor put, each once.
  std::vector<UnitParameters> missing() const;
  /// Units of all points that are wanted: so many syntheses it were if they shared none.
  std::int64_t without_sharing() const { return without_sharing_; }

  void put(const UnitParameters& unit, const UnitOutcome& outcome);

  /// A point that was wanted; before its units are there its fault says so.
  PointSilicon of(const knob_values& k) const;

 private:
  const Silicon& silicon_;
  std::function<std::optional<UnitSilicon>(const std::string& hash)> stored_;
  std::vector<UnitParameters> units_;           // each once, in the order of the points
  std::map<std::string, UnitOutcome> by_hash_;  // of those; without figures and fault: missing
  std::int64_t without_sharing_ = 0;
};

}  // namespace racebeam
