// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_info.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr const char* TopPrefix = "tt_um_";
constexpr double MostHz = 1e9;

/// The tree of the file, and the errors that name its lines.
class InfoFile {
 public:
  InfoFile(const std::string& text, const std::string& name) : name_(name) {
    try {
      root_ = YAML::Load(text);
    } catch (const YAML::ParserException& error) {
      fail(error.mark, error.msg + "; the file must be YAML");
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
    throw UsageError(mark.is_null() ? fmt::format("{}: {}", name_, what)
                                    : fmt::format("{}:{}: {}", name_, mark.line + 1, what));
  }

 private:
  const std::string name_;
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

std::vector<TtInfo::Source> read_sources(const InfoFile& info) {
  constexpr const char* Key = "source_files";
  constexpr const char* What = "a list of Verilog or SystemVerilog files";
  const YAML::Node list = info.project(Key, What);
  if (!list.IsSequence() || list.size() == 0)
    info.fail(list.Mark(), fmt::format("project.{} must be {}", Key, What));
  std::vector<TtInfo::Source> sources;
  for (const YAML::Node& node : list) {
    sources.push_back({info.text(node, Key, What), node.Mark().line + 1});
    // The system would take what is before it for the name.
    if (sources.back().name.find('\0') != std::string::npos)
      info.fail(node.Mark(), fmt::format("project.{}: a zero byte in the name of a file", Key));
  }
  return sources;
}

/// Hz, as YAML writes numbers: 25175000, 25_175_000, 25.175e6; negative: it is none.
double hz_of(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  double hz = 0;
  const bool good = YAML::convert<double>::decode(YAML::Node(text), hz) && hz >= 0 && hz <= MostHz;
  return good ? hz : -1;
}

std::uint64_t read_clock(const InfoFile& info) {
  constexpr const char* Key = "clock_hz";
  const YAML::Node node = info.find(Key);
  if (!node || node.IsNull()) return 0;
  const double hz = node.IsScalar() ? hz_of(node.Scalar()) : -1;
  if (hz < 0)
    info.fail(node.Mark(), fmt::format("project.{} must be the clock in Hz, such as 25175000, or 0 "
                                       "if it is not known; --clock-hz N overrides it",
                                       Key));
  return static_cast<std::uint64_t>(std::llround(hz));
}

}  // namespace

TtInfo read_tt_info(const std::string& text, const std::string& name, bool clock_is_known) {
  const InfoFile file(text, name);
  TtInfo info;
  info.top = read_top(file);
  info.sources = read_sources(file);
  if (!clock_is_known) info.clock_hz = read_clock(file);
  return info;
}

}  // namespace racebeam
