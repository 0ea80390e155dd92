// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "tb/base/content_hash.h"
#include "tb/base/errors.h"
#include "tb/base/whole_file.h"
#include "tb/tt/tt_info.h"
#include "tb/tt/tt_settings.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr long long LeastHz = 1'000'000, MostHz = 1'000'000'000;

/// That of `reading`, if it has one.
void take_clock(const TtReading& reading, const TtInfo& info, TtProject& project) {
  project.clock_hz = info.clock_hz;
  if (!reading.clock_hz) return;
  if (*reading.clock_hz < LeastHz || *reading.clock_hz > MostHz)
    throw UsageError(fmt::format("--clock-hz {} is out of range; {}..{} Hz", *reading.clock_hz,
                                 LeastHz, MostHz));
  project.clock_hz = static_cast<std::uint64_t>(*reading.clock_hz);
  project.clock_sure = true;
}

void find_sources(const TtInfo& info, const std::string& file, bool trust, TtProject& project) {
  const fs::path folder(project.folder);
  for (const TtInfo::Source& source : info.sources) {
    const std::string& name = source.name;
    const auto fail = [&](const std::string& what) {
      throw UsageError(fmt::format("{}:{}: {}", file, source.line, what));
    };
    const auto has = [&](const fs::path& place) {
      std::error_code error;
      return fs::is_regular_file(place / name, error);
    };
    if (!has(folder / "src") && !has(folder))
      fail(fmt::format("there is no source file {}, nor {}", (folder / "src" / name).string(),
                       (folder / name).string()));
    const fs::path place = has(folder / "src") ? folder / "src" : folder;
    if (!trust && !lies_in((place / name).string(), project.folder))
      fail(fmt::format("the source file {} lies outside of the project; --trust if you trust it",
                       name));
    if (project.sources.empty()) project.source_folder = place.string();
    project.sources.push_back((place / name).string());
  }
}

/// Include folders and defines.
void read_settings(const TtReading& reading, TtProject& project) {
  const fs::path folder(project.folder);
  std::ifstream json(folder / "src/config.json"), makefile(folder / "test/Makefile");
  const TtSettings config = read_config_json(json, (folder / "src").string());
  project.config_defines = config.defines;
  project.test_defines = read_test_defines(makefile);
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
  if (!std::ifstream(path)) throw UsageError(path.string() + " cannot be read");
  const TtInfo info = read_tt_info(whole_file(path.string()), path.string(), !!reading.clock_hz);
  TtProject project;
  project.folder = folder;
  project.top = info.top;
  find_sources(info, path.string(), reading.trust, project);
  take_clock(reading, info, project);
  read_settings(reading, project);
  std::string all;
  for (const std::string& file : project.sources) all += whole_file(file);
  project.hash = content_hash(all);
  return project;
}

}  // namespace racebeam
