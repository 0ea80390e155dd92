// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/unit_files.h"

#include <filesystem>
#include <sstream>
#include <system_error>

#include "sc/swap/rtl_remarks.h"
#include "tb/base/content_hash.h"
#include "tb/base/whole_file.h"
#include "tb/twin/use_option.h"
#include "tb/verilate/gate_netlist.h"
#include "tb/verilate/source_list.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

std::string how(const unit_choice& choice) { return choice.lockstep ? "lockstep" : "rtl"; }

}  // namespace

std::map<std::string, ManifestUnit> unit_files(const unit_choices& choices,
                                               const std::vector<std::string>& uses) {
  std::map<std::string, ManifestUnit> units;
  for (const auto& [name, choice] : choices.by_unit)
    if (choice.lockstep || choice.driver == unit_choice::Rtl)
      units[name].implementation = how(choice);
  for (const std::string& text : uses) {
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
      const auto equals = word.find('=');
      if (equals == std::string::npos) continue;
      const bool beside = word.find("lockstep:") == equals + 1;
      std::string text = word.substr((beside ? word.find(':') : equals) + 1);
      const auto gates = gate_word(text);
      for (auto& [name, one] : units)
        if (word.substr(0, equals) == AllUnits || word.substr(0, equals) == name) {
          one.files.clear();
          one.implementation = how(choices.of(name));
          if (gates) one.implementation = (beside ? "lockstep:gates:" : "gates:") + gates->kind;
        }
      const auto unit = units.find(word.substr(0, equals));
      if (unit == units.end()) continue;
      if (gates) text = gates->file;
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
