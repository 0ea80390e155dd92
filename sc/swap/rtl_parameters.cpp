// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_parameters.h"

#include <cstdlib>
#include <sstream>

namespace racebeam {

std::vector<rtl_parameter> other_parameters(const std::map<std::string, std::int64_t>& built,
                                            const std::vector<rtl_parameter>& wanted) {
  std::vector<rtl_parameter> other;
  for (const rtl_parameter& parameter : wanted)
    if (const auto at = built.find(parameter.name);
        at != built.end() && at->second != parameter.value)
      other.push_back(parameter);
  return other;
}

std::map<std::string, std::int64_t> built_parameters(const rtl_model& model) {
  std::map<std::string, std::int64_t> built;
  std::istringstream words(model.parameters);
  for (std::string word; words >> word;)
    if (const auto equals = word.find('='); equals != std::string::npos)
      built[word.substr(0, equals)] = std::strtoll(word.c_str() + equals + 1, nullptr, 10);
  return built;
}

}  // namespace racebeam
