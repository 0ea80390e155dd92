// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt_project.h"

#include <fmt/format.h>
#include <xxhash.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "sc/constants.h"
#include "tb/errors.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* TopPrefix = "tt_um_";
constexpr int MaxClocksPerPixel = 8;
constexpr double ClockTolerance = 0.01;

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

  /// The value of project.KEY.
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

void read_clock(const InfoFile& info, TtProject& project) {
  constexpr const char* Key = "clock_hz";
  constexpr const char* What = "the clock in Hz, such as 25175000";
  const YAML::Node node = info.project(Key, What);
  double hz = 0;
  if (!YAML::convert<double>::decode(node, hz) || !std::isfinite(hz))
    info.fail(node.Mark(), fmt::format("project.{} must be {}", Key, What));
  const double pixels = std::round(hz / PixelClockHz);
  if (pixels < 1 || pixels > MaxClocksPerPixel ||
      std::abs(hz - pixels * PixelClockHz) > ClockTolerance * pixels * PixelClockHz)
    info.fail(node.Mark(),
              fmt::format("project.{} is {}; 640x480 at 60 Hz needs 25.2 MHz, or a multiple up to "
                          "{} times, within 1 %: 25175000, 25200000, 50350000, 50400000 ...",
                          Key, node.Scalar(), MaxClocksPerPixel));
  project.clock_hz = static_cast<std::uint64_t>(hz);
  project.clocks_per_pixel = static_cast<int>(pixels);
}

void read_sources(const InfoFile& info, TtProject& project) {
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
    if (project.sources.empty()) project.source_folder = place.string();
    project.sources.push_back((place / name).string());
  }
}

std::string hash_of(const std::vector<std::string>& files) {
  std::string all;
  for (const std::string& file : files) {
    std::ifstream in(file, std::ios::binary);
    all.append(std::istreambuf_iterator<char>(in), {});
  }
  return fmt::format("xxh64 {:016x}", XXH64(all.data(), all.size(), 0));
}

}  // namespace

TtProject read_tt_project(const std::string& folder) {
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
  read_sources(info, project);
  read_clock(info, project);
  project.hash = hash_of(project.sources);
  return project;
}

}  // namespace racebeam
