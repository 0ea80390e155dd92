// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/nearest.h"

#include <algorithm>
#include <numeric>

namespace racebeam {

namespace {

// Edits (insert, delete, replace) that turn `a` into `b`.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (letter != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min(replaced, std::min(diagonal, row[j]) + 1);
    }
  }
  return row.back();
}

// The shortest known name that begins with `name`, or else holds it; empty if none does.
std::string completed(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t Shortest = 3;  // fewer letters are in many names
  std::string best;
  bool begins = false;
  if (name.size() < Shortest) return best;
  for (const std::string& candidate : known) {
    const std::size_t at = candidate.find(name);
    if (at == std::string::npos || (begins && at > 0)) continue;
    if (!best.empty() && begins == (at == 0) && candidate.size() >= best.size()) continue;
    best = candidate;
    begins = at == 0;
  }
  return best;
}

}  // namespace

std::string nearest(const std::string& name, const std::vector<std::string>& known) {
  std::string best = completed(name, known);
  if (!best.empty()) return best;
  std::size_t best_distance = name.size() / 2 + 1;  // more than that is a different word
  const auto is_too_far = [&](std::size_t distance) {
    return distance > best_distance || (distance == best_distance && !best.empty());
  };
  for (const std::string& candidate : known) {
    const auto [shorter, longer] = std::minmax({name.size(), candidate.size()});
    if (is_too_far(longer - shorter)) continue;  // so many letters are to be inserted
    const std::size_t distance = edit_distance(name, candidate);
    if (is_too_far(distance)) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

UsageError unknown_name(const std::string& kind, const std::string& name,
                        const std::vector<std::string>& known) {
  std::string message = "unknown " + kind + " '" + name + "'";
  const std::string meant = nearest(name, known);
  if (!meant.empty()) message += "; did you mean '" + meant + "'?";
  std::string all;
  for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
  return UsageError(message + " (there is: " + all + ")");
}

}  // namespace racebeam
