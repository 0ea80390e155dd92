// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/plugin_maker.h"

#include <stdlib.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "sc/rtl_plugin.h"
#include "tb/errors.h"
#include "tb/scene/program_tables.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

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

std::string scratch(const std::string& file) {
  static const ScratchFolder folder;
  return (folder.path() / file).string();
}

void need_verilator(const std::string& instead = ", or name a .so") {
  if (std::system("command -v verilator >/dev/null") != 0)
    throw MissingTool("verilator is not installed; install the package `verilator`" + instead);
}

/// Name="file", which holds `text`, for $readmemh.
std::string table_parameter(const std::string& name, const std::string& text) {
  const std::string file = scratch(name + ".hex");
  std::ofstream(file) << text;
  return name + "=\"" + file + "\"";
}

}  // namespace

std::vector<std::string> PluginMaker::table_parameters(const std::string& unit) const {
  if (!program_) return {};
  if (unit == "timeline")
    return {"Shots=" + std::to_string(program_->shots.size()),
            table_parameter("ShotFile", shot_table(*program_))};
  if (unit == "scene_rom")
    return {"Rooms=" + std::to_string(program_->rooms.size()),
            table_parameter("RoomFile", room_table(*program_))};
  return {};
}

std::string PluginMaker::own(const std::string& unit) const {
  std::vector<std::string> parameters = table_parameters(unit);
  if (parameters.empty()) {
    if (!traced_) return "";
    need_verilator("");
    return rtl_plugin_path(unit, knobs_, true);
  }
  need_verilator();
  const std::string plugin = scratch(unit + ".own.so");
  for (const auto& other : other_parameters(rtl_library(rtl_plugin_path(unit, {})).model(), knobs_))
    parameters.push_back(other);
  build_rtl_plugin(unit, {}, parameters, plugin, traced_);
  return plugin;
}

std::string PluginMaker::users(const std::string& unit, const std::string& file) const {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw UsageError("there is no file '" + file + "' for the unit " + unit);
  if (fs::path(file).extension() == ".so") return file;
  need_verilator();
  const std::string plugin = scratch(unit + ".so");
  std::vector<std::string> parameters = table_parameters(unit);
  build_rtl_plugin(unit, {file}, parameters, plugin, traced_);
  const auto other = other_parameters(rtl_library(plugin).model(), knobs_);
  if (other.empty()) return plugin;
  parameters.insert(parameters.end(), other.begin(), other.end());
  build_rtl_plugin(unit, {file}, parameters, plugin, traced_);
  return plugin;
}

std::string make_chip_plugin(const std::string& top, const std::vector<std::string>& sources) {
  need_verilator("");
  const std::string plugin = scratch(top + ".so");
  build_chip_plugin(top, sources, plugin);
  return plugin;
}

}  // namespace racebeam
