// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/unit_files.h"

#include <filesystem>
#include <sstream>
#include <system_error>

#include "sc/swap/rtl_remarks.h"
#include "tb/base/content_hash.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/source_list.h"

namespace racebeam {

namespace fs = std::filesystem;

std::map<std::string, ManifestUnit> unit_files(const unit_choices& choices,
                                               const std::vector<std::string>& uses) {
  std::map<std::string, ManifestUnit> units;
  for (const auto& [name, choice] : choices.by_unit)
    if (choice.lockstep || choice.driver == unit_choice::Rtl)
      units[name].implementation = choice.lockstep ? "lockstep" : "rtl";
  for (const std::string& text : uses) {
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
      const auto equals = word.find('=');
      const auto unit = units.find(word.substr(0, equals));
      if (equals == std::string::npos || unit == units.end()) continue;
      const auto start = word.find("lockstep:") == equals + 1 ? word.find(':') : equals;
      unit->second.files.clear();
      const std::string text = word.substr(start + 1);
      if (text == "rtl" || text == "lockstep") continue;  // ours, even beside a folder of that name
      if (!is_source_list(text) && fs::path(text).extension() != ".so") continue;
      for (const std::string& file :
           is_source_list(text) ? files_of_list(unit->first, text) : std::vector{text}) {
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored))
          unit->second.files[nearer_path(file)] = content_hash(whole_file(file));
      }
    }
  }
  return units;
}

}  // namespace racebeam
