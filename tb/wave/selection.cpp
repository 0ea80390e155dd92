// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/selection.h"

#include <fnmatch.h>

#include <algorithm>

namespace racebeam {

bool any_matches(const std::vector<std::string>& patterns, const std::string& path) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), path.c_str(), 0) == 0 ||
           fnmatch((pattern + ".*").c_str(), path.c_str(), 0) == 0;
  });
}

bool TraceSelection::takes(const std::string& path) const {
  if (depth > 0 && std::count(path.begin(), path.end(), '.') > depth) return false;
  return scopes.empty() || any_matches(scopes, path);
}

}  // namespace racebeam
