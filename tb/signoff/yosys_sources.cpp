// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/yosys_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/project_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// The names of the links to the files: their own, if no other file has it.
std::vector<std::string> link_names(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& file : files) {
    std::string name = fs::path(file).filename().string();
    while (name == "rtl" || name.rfind("folder", 0) == 0 ||
           std::find(names.begin(), names.end(), name) != names.end())
      name = "other_" + name;
    names.push_back(name);
  }
  return names;
}

fs::path whole(const std::string& folder) {
  return fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder));
}

/// Folders in which yosys looks for what the files include and lack.
struct SearchedFolders {
  std::vector<std::string> included, libraries;           // as they are called in a work folder
  std::vector<std::pair<std::string, fs::path>> to_link;  // those that are not below rtl/

  explicit SearchedFolders(const RtlSources& sources) {
    std::vector<std::string> beside;
    for (const std::string& file : sources.files)
      beside.push_back(name_of_folder(fs::absolute(file).parent_path()));
    for (const std::string& folder : sources.include_folders) add(included, name_of_folder(folder));
    for (const std::string& folder : sources.libraries)
      if (fs::is_directory(folder)) add(libraries, name_of_folder(folder));
    for (auto* names : {&included, &libraries})
      for (const std::string& name : beside) add(*names, name);
    for (const std::string& folder : rtl_folders()) add(libraries, name_of_folder(folder));
  }

 private:
  static void add(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::string name_of_folder(const std::string& folder) {
    const fs::path at = whole(folder);
    for (const std::string& ours : rtl_folders())
      if (at == whole(ours)) return "rtl/" + at.filename().string();
    for (const auto& [name, target] : to_link)
      if (target == at) return name;
    to_link.emplace_back("folder" + std::to_string(to_link.size() + 1), at);
    return to_link.back().first;
  }
};

// yosys 0.23 reads no -1.
std::string yosys_value(const std::string& value) {
  if (value.size() > 1 && value[0] == '-' &&
      value.find_first_not_of("0123456789", 1) == std::string::npos)
    return fmt::format("32'sh{:08x}", static_cast<std::uint32_t>(std::stoll(value)));
  return value;
}

bool is_package(const fs::path& file) {
  const std::string name = file.filename().string(), end = "_pkg.sv";
  return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

/// The project's packages but those that the sources bring, by their places in the folder.
std::vector<std::string> packages(const RtlSources& sources) {
  std::vector<std::string> all;
  for (const std::string& folder : rtl_folders())
    for (const auto& entry : fs::directory_iterator(folder)) {
      const auto brings = [&](const std::string& file) {
        return fs::path(file).filename() == entry.path().filename();
      };
      if (is_package(entry.path()) &&
          std::none_of(sources.files.begin(), sources.files.end(), brings))
        all.push_back("rtl/" + fs::path(folder).filename().string() + "/" +
                      entry.path().filename().string());
    }
  std::sort(all.begin(), all.end());
  return all;
}

// Of the clock in which they are looked at, not of the one after; `opt` would give their registers
// a reset, which these do not have.
constexpr const char* AtTheirClock = "chformal -assert -early\n";

}  // namespace

void link_sources(const RtlSources& sources, const std::string& folder) {
  fs::create_directory_symlink(rtl_folder(), folder + "/rtl");
  const std::vector<std::string> names = link_names(sources.files);
  for (std::size_t n = 0; n < names.size(); ++n)
    fs::create_symlink(fs::absolute(sources.files[n]), folder + "/" + names[n]);
  for (const auto& [name, target] : SearchedFolders(sources).to_link)
    fs::create_directory_symlink(target, folder + "/" + name);
}

std::string reading_commands(const RtlSources& sources, bool assertions) {
  std::string options = " -sv", libraries, text, settings;
  const SearchedFolders folders(sources);
  for (const std::string& one : folders.included) options += " -I" + one;
  for (const std::string& one : sources.defines) options += " -D" + one;
  for (const std::string& one : folders.libraries) libraries += " -libdir " + one;
  if (assertions) text = "verilog_defaults -add -formal\n";  // for what it finds in folders, too
  text += "read_verilog" + options;
  for (const std::string& package : packages(sources)) text += " " + package;
  for (const std::string& name : link_names(sources.files)) text += " " + name;
  for (const std::string& parameter : sources.parameters) {
    const auto equals = parameter.find('=');
    settings += fmt::format(" -set {} {}", parameter.substr(0, equals),
                            yosys_value(parameter.substr(equals + 1)));
  }
  if (!settings.empty()) text += "\nchparam" + settings + " " + sources.top;
  return text +
         fmt::format(
             "\nhierarchy -check -top {0}{1}\nrename -top {0}\nproc -norom\nflatten\n{2}opt\n",
             sources.top, libraries, assertions ? AtTheirClock : "");
}

void run_yosys(const std::string& commands, const std::string& folder, const std::string& unit) {
  if (!has_tool("yosys")) throw MissingTool("yosys is not installed; scripts/setup installs it");
  std::ofstream(folder + "/commands.ys") << commands;
  const ToolResult result = run_tool({{"yosys", "-q", "-s", "commands.ys"}, folder, {}, {}});
  if (!result.good && interrupted()) throw Interrupted();
  if (!result.good) throw RtlError("yosys cannot make a netlist of " + unit + ":\n" + result.said);
}

}  // namespace racebeam
