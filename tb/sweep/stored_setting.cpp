// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/stored_setting.h"

#include <algorithm>

#include "tb/sweep/schema.h"

namespace racebeam {

bool read_setting(const std::string& text, knob_values& k, SweepReference& reference) {
  const auto& words = reference_words();
  for (const auto& [name, value] : setting_of(text)) {
    if (name == "reference") {
      const auto at = std::find(words.begin(), words.end(), value);
      if (at == words.end()) return false;
      reference = static_cast<SweepReference>(at - words.begin());
    }
    for (std::size_t at = 0; at < k.rows().size(); ++at) {
      const knob_row& row = k.rows()[at];
      if (name != row.name) continue;
      int number = row.min;
      while (number <= row.max && row.text(number) != value) ++number;
      if (number > row.max) return false;
      k[at] = number;
    }
  }
  return true;
}

}  // namespace racebeam
