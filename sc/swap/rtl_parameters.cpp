// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_parameters.h"

#include <cctype>
#include <cstdlib>
#include <sstream>

namespace racebeam {

namespace {

// interval_stack_depth -> IntervalStackDepth
std::string parameter_name(const std::string& knob) {
  std::string name;
  bool capital = true;
  for (const char c : knob) {
    if (c != '_') name += capital ? static_cast<char>(std::toupper(c)) : c;
    capital = c == '_';
  }
  return name;
}

}  // namespace

std::vector<rtl_parameter> rtl_parameters(const knobs& k) {
  std::vector<rtl_parameter> all;
  const auto add = [&](const std::string& knob, int value) {
    all.push_back({parameter_name(knob), knob, value});
  };
  for (const auto& row : knob_table()) add(row.name, k.*row.member);
  return all;
}

std::vector<rtl_parameter> other_parameters(const std::map<std::string, int>& built,
                                            const knobs& k) {
  std::vector<rtl_parameter> other;
  for (const rtl_parameter& parameter : rtl_parameters(k))
    if (const auto at = built.find(parameter.name);
        at != built.end() && at->second != parameter.value)
      other.push_back(parameter);
  return other;
}

std::map<std::string, int> built_parameters(const rtl_model& model) {
  std::map<std::string, int> built;
  std::istringstream words(model.parameters);
  for (std::string word; words >> word;)
    if (const auto equals = word.find('='); equals != std::string::npos)
      built[word.substr(0, equals)] = std::atoi(word.c_str() + equals + 1);
  return built;
}

}  // namespace racebeam
