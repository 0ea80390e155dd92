// What of a hierarchy of signals is meant, by its paths.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// Whether a path, or what holds it, has the form of one of the shell patterns.
bool any_matches(const std::vector<std::string>& patterns, const std::string& path);

/// Which signals are wanted. Those of `beam` always are.
struct TraceSelection {
  std::vector<std::string> scopes;  ///< shell patterns of paths or of what holds them; none: all
  int depth = 0;                    ///< levels of the hierarchy, 1: the chip's own; 0: all

  bool takes(const std::string& path) const;
};

/// A port of a unit in lockstep whose sides differ: the model has it as SCOPE.NAME, the RTL as
/// SCOPE.rtl.NAME.
struct DifferingPort {
  std::string scope, name;
};

}  // namespace racebeam
