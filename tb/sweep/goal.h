// Goal: what a sweep wants of a figure.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace racebeam {

enum class GoalKind { Limit, Min, Max };

/// What is wanted of a figure, in the figure's unit.
struct Goal {
  std::string figure;
  GoalKind kind = GoalKind::Limit;
  std::optional<double> least{}, most{};  ///< beyond them a point is not wanted
};

}  // namespace racebeam
