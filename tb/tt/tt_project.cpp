// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_project.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "tb/base/content_hash.h"
#include "tb/base/errors.h"
#include "tb/base/whole_file.h"
#include "tb/tt/tt_settings.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* TopPrefix = "tt_um_";
constexpr long long LeastHz = 1'000'000;
constexpr double MostHz = 1e9;

/// info.yaml, and the errors that name its lines.
class InfoFile {
 public:
  explicit InfoFile(const fs::path& path) : path_(path.string()) {
    try {
      root_ = YAML::LoadFile(path_);
    } catch (const YAML::ParserException& error) {
      fail(error.mark, error.msg + "; the file must be YAML");
    } catch (const YAML::BadFile&) {
      throw UsageError(path_ + " cannot be read");
    }
  }

  /// The value of project.KEY, if there is one.
  YAML::Node find(const char* key) const { return root_["project"][key]; }
  /// The same; it must be there.
  YAML::Node project(const char* key, const char* what) const {
    const YAML::Node project = root_.IsMap() ? root_["project"] : YAML::Node();
    if (!project || !project.IsMap())
      fail(project ? project.Mark() : root_.Mark(),
           "there is no section `project:` with top_module, source_files and clock_hz");
    const YAML::Node value = project[key];
    if (!value) fail(project.Mark(), fmt::format("project.{} is missing: {}", key, what));
    return value;
  }
  std::string text(const YAML::Node& node, const char* key, const char* what) const {
    if (!node.IsScalar() || node.Scalar().empty())
      fail(node.Mark(), fmt::format("project.{} must be {}", key, what));
    return node.Scalar();
  }
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    throw UsageError(mark.is_null() ? fmt::format("{}: {}", path_, what)
                                    : fmt::format("{}:{}: {}", path_, mark.line + 1, what));
  }

 private:
  const std::string path_;
  YAML::Node root_;
};

std::string read_top(const InfoFile& info) {
  constexpr const char* Key = "top_module";
  constexpr const char* What = "the name of the top module, tt_um_...";
  const YAML::Node node = info.project(Key, What);
  const std::string top = info.text(node, Key, What);
  const bool word = std::all_of(top.begin(), top.end(),
                                [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!word || top.rfind(TopPrefix, 0) != 0)
    info.fail(node.Mark(), fmt::format("project.{} is '{}', must be {}", Key, top, What));
  return top;
}

/// Hz, as YAML writes numbers: 25175000, 25_175_000, 25.175e6; negative: it is none.
double hz_of(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  double hz = 0;
  const bool good = YAML::convert<double>::decode(YAML::Node(text), hz) && hz >= 0 && hz <= MostHz;
  return good ? hz : -1;
}

void read_clock(const InfoFile& info, const TtReading& reading, TtProject& project) {
  constexpr const char* Key = "clock_hz";
  if (reading.clock_hz) {
    if (*reading.clock_hz < LeastHz || *reading.clock_hz > static_cast<long long>(MostHz))
      throw UsageError(fmt::format("--clock-hz {} is out of range; {}..{} Hz", *reading.clock_hz,
                                   LeastHz, static_cast<long long>(MostHz)));
    project.clock_hz = static_cast<std::uint64_t>(*reading.clock_hz);
    project.clock_sure = true;
    return;
  }
  const YAML::Node node = info.find(Key);
  if (!node || node.IsNull()) return;
  const double hz = node.IsScalar() ? hz_of(node.Scalar()) : -1;
  if (hz < 0)
    info.fail(node.Mark(), fmt::format("project.{} must be the clock in Hz, such as 25175000, or 0 "
                                       "if it is not known; --clock-hz N overrides it",
                                       Key));
  project.clock_hz = static_cast<std::uint64_t>(std::llround(hz));
}

void read_sources(const InfoFile& info, bool trust, TtProject& project) {
  constexpr const char* Key = "source_files";
  constexpr const char* What = "a list of Verilog or SystemVerilog files";
  const YAML::Node list = info.project(Key, What);
  if (!list.IsSequence() || list.size() == 0)
    info.fail(list.Mark(), fmt::format("project.{} must be {}", Key, What));
  const fs::path folder(project.folder);
  for (const YAML::Node& node : list) {
    const std::string name = info.text(node, Key, What);
    const auto has = [&](const fs::path& place) {
      std::error_code error;
      return fs::is_regular_file(place / name, error);
    };
    if (!has(folder / "src") && !has(folder))
      info.fail(node.Mark(),
                fmt::format("there is no source file {}, nor {}", (folder / "src" / name).string(),
                            (folder / name).string()));
    const fs::path place = has(folder / "src") ? folder / "src" : folder;
    if (!trust && !lies_in((place / name).string(), project.folder))
      info.fail(node.Mark(), fmt::format("the source file {} lies outside of the project; --trust "
                                         "if you trust it",
                                         name));
    if (project.sources.empty()) project.source_folder = place.string();
    project.sources.push_back((place / name).string());
  }
}

/// Include folders and defines.
void read_settings(const TtReading& reading, TtProject& project) {
  const fs::path folder(project.folder);
  const TtSettings config = read_config_json((folder / "src/config.json").string());
  project.config_defines = config.defines;
  project.test_defines = read_test_defines((folder / "test/Makefile").string());
  project.defines = reading.defines;
  project.defines.insert(project.defines.end(), config.defines.begin(), config.defines.end());
  auto& folders = project.include_folders;
  for (const std::string& name : reading.include_folders) {
    std::error_code error;
    if (!fs::is_directory(name, error)) throw UsageError("--include: there is no folder " + name);
    folders.push_back(name);
    project.trusted_folders.push_back(name);
  }
  folders.insert(folders.end(), config.include_folders.begin(), config.include_folders.end());
  std::vector<std::string> found = {project.source_folder};
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder / "src", error), end; !error && at != end;
       at.increment(error))
    if (at->is_directory(error)) found.push_back(at->path().string());
  std::sort(found.begin() + 1, found.end());
  folders.insert(folders.end(), found.begin(), found.end());
}

}  // namespace

bool lies_in(const std::string& path, const std::string& folder) {
  std::error_code error;
  const fs::path inner =
      fs::weakly_canonical(path, error).lexically_relative(fs::weakly_canonical(folder, error));
  return !error && !inner.empty() && *inner.begin() != "..";
}

TtProject read_tt_project(const std::string& folder, const TtReading& reading) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw UsageError("there is no folder '" + folder + "'; --tt takes a Tiny Tapeout project");
  const fs::path path = fs::path(folder) / "info.yaml";
  if (!fs::is_regular_file(path, error))
    throw UsageError("there is no " + path.string() + "; --tt takes a Tiny Tapeout project");
  const InfoFile info(path);
  TtProject project;
  project.folder = folder;
  project.top = read_top(info);
  read_sources(info, reading.trust, project);
  read_clock(info, reading, project);
  read_settings(reading, project);
  std::string all;
  for (const std::string& file : project.sources) all += whole_file(file);
  project.hash = content_hash(all);
  return project;
}

}  // namespace racebeam
