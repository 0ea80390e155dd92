// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_remarks.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "sc/swap/rtl_library.h"

namespace racebeam {

std::string nearer_path(const std::string& path) {
  std::error_code error;
  const std::string near = std::filesystem::proximate(path, error).string();
  return error || near.size() > path.size() ? path : near;
}

std::vector<std::string> remarks_of(const rtl_model& model, const std::string& kind) {
  std::vector<std::string> found;
  std::istringstream lines(model.remarks ? model.remarks : "");
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(kind + " ", 0) != 0) continue;
    std::string rest = nearer_path(line.substr(kind.size() + 1));
    rest.erase(rest.find_last_not_of(' ') + 1);
    if (std::find(found.begin(), found.end(), rest) == found.end()) found.push_back(rest);
  }
  return found;
}

std::set<std::string> quiet_inputs_of(const rtl_model& model) {
  std::set<std::string> names;
  for (const std::string& place : remarks_of(model, "quiet"))
    names.insert(place.substr(place.rfind('.') + 1));
  return names;
}

void tell_not_quiet(const rtl_model& model, const std::string& output) {
  throw RtlFault("the output " + output + " of " + model.unit +
                 " follows within a clock from an input of which yosys has found no such path; "
                 "write its logic so that yosys and Verilator read the same");
}

std::string remarks_text(const rtl_model& model, const std::string& kind) {
  constexpr std::size_t Most = 8;
  const std::vector<std::string> all = remarks_of(model, kind);
  std::string text;
  for (std::size_t n = 0; n < std::min(all.size(), Most); ++n) text += (n ? ", " : "") + all[n];
  return text + (all.size() > Most ? ", ..." : "");
}

}  // namespace racebeam
