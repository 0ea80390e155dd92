// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/coverage_points.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <tuple>

#include "sc/swap/rtl_library.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/clock_wrapper.h"

namespace racebeam {

namespace {

constexpr char KeyBegins = '\001', ValueBegins = '\002';

auto order(const CoveragePoint& point) {
  return std::tie(point.file, point.line, point.column, point.kind, point.module, point.name);
}

/// "C '^Akey^Bvalue^Akey^Bvalue' COUNT".
std::map<std::string, std::string> fields_of(const std::string& line) {
  const std::size_t from = line.find('\''), to = line.rfind("' ");
  if (line.rfind("C ", 0) != 0 || from == std::string::npos || to <= from) return {};
  std::map<std::string, std::string> fields = {{"count", line.substr(to + 2)}};
  std::istringstream parts(line.substr(from + 1, to - from - 1));
  for (std::string part; std::getline(parts, part, KeyBegins);)
    if (const std::size_t split = part.find(ValueBegins); split != std::string::npos)
      fields[part.substr(0, split)] = part.substr(split + 1);
  return fields;
}

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t");
  return from == std::string::npos ? ""
                                   : text.substr(from, text.find_last_not_of(" \t\r") + 1 - from);
}

/// Lines of sources by number.
class Sources {
 public:
  std::string line(const std::string& file, int number) {
    auto& lines = files_[file];
    if (lines.empty()) {
      std::ifstream in(file);
      lines.emplace_back();
      for (std::string one; std::getline(in, one);) lines.push_back(trimmed(one));
    }
    const auto at = static_cast<std::size_t>(number);
    return at < lines.size() ? lines[at] : "";
  }

 private:
  std::map<std::string, std::vector<std::string>> files_;
};

/// From the project's folder on.
std::string short_name(const std::string& file) {
  const std::string inside =
      std::filesystem::path(file).lexically_relative(project_folder()).string();
  return inside.empty() || inside.rfind("..", 0) == 0 ? file : inside;
}

/// A bit that only goes up, in each of two instances or runs, has not moved up and down.
void merge(CoveragePoint& to, const CoveragePoint& more) {
  if (to.kind == CoveragePoint::Toggle) to.count = std::max(to.count, more.count);
  else to.count += more.count;
}

}  // namespace

std::vector<CoveragePoint> read_coverage(const std::string& path) {
  static const std::map<std::string, CoveragePoint::Kind> Pages = {
      {"v_line", CoveragePoint::Line},
      {"v_branch", CoveragePoint::Branch},
      {"v_toggle", CoveragePoint::Toggle}};
  Sources sources;
  std::vector<CoveragePoint> points;
  std::istringstream lines(whole_file(path));
  std::string line;
  std::getline(lines, line);  // "# SystemC::Coverage-3"
  if (line.find("Coverage") == std::string::npos)
    throw RtlError(path + " does not begin as a coverage file of Verilator");
  while (std::getline(lines, line)) {
    auto fields = fields_of(line);
    const std::string& page = fields["page"];
    const auto kind = Pages.find(page.substr(0, page.find('/')));
    if (fields["f"].empty() || kind == Pages.end())
      throw RtlError(path + " has a line that is no line, branch or toggle: " + line);
    CoveragePoint point;
    point.kind = kind->second;
    point.module = page.substr(page.find('/') + 1);
    point.module.resize(std::min(point.module.size(), point.module.find("__")));  // parameters
    if (point.module == Wrapper) continue;
    point.line = std::atoi(fields["l"].c_str());
    point.column = std::atoi(fields["n"].c_str());
    point.name = fields["o"];
    point.text = sources.line(fields["f"], point.line);
    point.file = short_name(fields["f"]);
    point.count = std::strtoull(fields["count"].c_str(), nullptr, 10);
    points.push_back(std::move(point));
  }
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return order(a) < order(b); });
  std::vector<CoveragePoint> all;
  for (CoveragePoint& point : points)
    if (!all.empty() && order(all.back()) == order(point)) merge(all.back(), point);
    else all.push_back(std::move(point));
  return all;
}

void add_coverage(std::vector<CoveragePoint>& to, const std::vector<CoveragePoint>& more) {
  if (to.empty()) to = more;
  else
    for (std::size_t n = 0; n < to.size() && n < more.size(); ++n) merge(to[n], more[n]);
}

}  // namespace racebeam
