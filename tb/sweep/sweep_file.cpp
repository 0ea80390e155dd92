// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_file.h"

#include <fnmatch.h>

#include <algorithm>

#include "tb/show/set_knob.h"

namespace racebeam {

bool SweepFrames::skips(const std::string& part) const {
  return std::any_of(skip.begin(), skip.end(), [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), part.c_str(), 0) == 0;
  });
}

const std::vector<std::string>& method_words() {
  static const std::vector<std::string> words = {"grid", "one-by-one", "sobol", "nsga2"};
  return words;
}

const std::vector<std::string>& goal_words() {
  static const std::vector<std::string> words = {"min", "max"};
  return words;
}

const std::vector<std::string>& reference_words() { return picture_reference_names(); }

void narrow(SweepFile& file, const std::string& assignment) {
  SweepPoint point{"", file.built->standard(nullptr)};
  set_knob(point.k, assignment);
  const std::string name = assignment.substr(0, assignment.find('='));
  const knob_row* row = swept_knob(*file.built, name);
  const KnobValues only{row, {point.value_of(*row)}, true};
  const auto at = std::find_if(file.knobs.begin(), file.knobs.end(),
                               [&](const KnobValues& one) { return one.row == row; });
  if (at != file.knobs.end()) *at = only;
  else file.knobs.push_back(only);
}

}  // namespace racebeam
