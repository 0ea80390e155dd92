// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/use_option.h"

#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "sc/rtl_plugin.h"
#include "tb/nearest.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* All = "all";

/// A folder that goes with the program.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "racebeam.XXXXXX").string();
    if (!mkdtemp(name.data())) throw MissingTool("there is no place for temporary files");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

unit_choice choice_of(const std::string& unit, const std::string& text, const knobs& k) {
  if (text == "model") return {};
  if (text == "rtl") return {unit_choice::Rtl, false, ""};
  if (text == "lockstep") return {unit_choice::Model, true, ""};
  const std::string extension = fs::path(text).extension().string();
  if (extension == ".sv" || extension == ".v" || extension == ".so")
    return {unit_choice::Rtl, false, user_plugin(unit, text, k)};
  throw unknown_name("implementation", text, {"model", "rtl", "lockstep", "FILE.sv", "FILE.so"});
}

void use_one(unit_choices& choices, const std::string& text, const knobs& k) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw UsageError("'" + text +
                     "' is not of the form UNIT=model, UNIT=rtl, UNIT=lockstep or "
                     "UNIT=FILE.sv");
  const std::string unit = text.substr(0, equals), how = text.substr(equals + 1);
  if (unit != All) {
    check_unit(unit);
    choices.by_unit[unit] = choice_of(unit, how, k);
    return;
  }
  if (how != "model" && how != "rtl" && how != "lockstep")
    throw UsageError("all=" + how + ": all units can be model, rtl or lockstep; a file is for one");
  for (const std::string& each : chip_units()) choices.by_unit[each] = choice_of(each, how, k);
}

}  // namespace

void check_unit(const std::string& unit) {
  const auto& units = chip_units();
  if (std::find(units.begin(), units.end(), unit) != units.end()) return;
  std::vector<std::string> known = units;
  known.push_back(All);
  throw unknown_name("unit", unit, known);
}

std::string user_plugin(const std::string& unit, const std::string& file, const knobs& k) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw UsageError("there is no file '" + file + "' for the unit " + unit);
  if (fs::path(file).extension() == ".so") return file;
  static const ScratchFolder scratch;
  const std::string plugin = (scratch.path() / (unit + ".so")).string();
  if (std::system("command -v verilator >/dev/null") != 0)
    throw MissingTool("verilator is not installed; install the package `verilator`, or name a .so");
  build_rtl_plugin(unit, {file}, {}, plugin);
  if (const auto other = other_parameters(plugin, k); !other.empty())
    build_rtl_plugin(unit, {file}, other, plugin);
  return plugin;
}

void check_tables(const unit_choices& choices, bool scene_file) {
  for (const char* unit : {"sequencer", "scene"}) {
    const unit_choice& choice = choices.of(unit);
    if (scene_file && (choice.driver == unit_choice::Rtl || choice.lockstep))
      throw UsageError(std::string(unit) +
                       " can be RTL in the built-in demo only: a scene file puts a table in its "
                       "place; leave it a model");
  }
}

void use_units(unit_choices& choices, const std::string& text, const knobs& k) {
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) use_one(choices, part, k);
}

}  // namespace racebeam
