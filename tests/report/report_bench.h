// What tests of reports begin with: the folder of a sweep whose frames follow from a formula.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "sc/beam/engine.h"
#include "tb/report/report_page.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/export.h"
#include "tb/sweep/row_digest.h"
#include "tests/support/json.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {

class ReportFolder {
 public:
  /// The sweep is not begun with its first frames until put().
  explicit ReportFolder(const std::string& text)
      : plan_(plan_sweep_text(text, "s")), store_(folder_ / "sweep.sqlite", Access::Write) {
    std::ofstream(folder_ / "sweep.toml") << text;
    key_.model = store_.model({"0f77e52f9dc31c8b", "0.2.0", "abc", "program", "g++"}, columns());
    key_.scene = store_.scene({"demo", plan_.scenes[0].show.hash(), plan_.scenes[0].show.frames()});
    std::vector<StoredPoint> all;
    for (const PlannedPoint& point : plan_.points)
      all.push_back({point.settings[0], point.point.name});
    ids_ = store_.points(all);
    say("done", plan_.sample(0));
  }

  static const std::vector<std::string>& columns() {
    static const std::vector<std::string> names = sweep_columns(beam_engine());
    return names;
  }
  int points() const { return static_cast<int>(plan_.points.size()); }
  const SweepPlan& plan() const { return plan_; }
  Store& store() { return store_; }
  std::string path() const { return folder_.path(); }
  FrameKey key(int point) const {
    return {key_.model, key_.scene, ids_[static_cast<std::size_t>(point)]};
  }

  void say(const std::string& state, int rung) const {
    std::ofstream(folder_ / "status.json")
        << Json{{"name", plan_.file.name}, {"state", state}, {"rung", rung}}.dump();
  }
  /// What a counter is in a frame of a point: other points have others.
  static std::int64_t value(std::size_t column, int point, int frame) {
    return 1000 + 37 * std::int64_t(column) + point * (50 + std::int64_t(column)) + frame % 97;
  }
  /// The first `count` frames of its sample.
  void put(int point, int count) {
    std::vector<MeasuredFrame> block;
    for (int i = 0; i < count; ++i) {
      MeasuredFrame frame;
      frame.row.frame = plan_.scenes[0].order[static_cast<std::size_t>(i)];
      for (std::size_t column = 0; column < columns().size(); ++column)
        frame.row.values.push_back(value(column, point, frame.row.frame));
      frame.row.digest = frame_digest(frame.row.frame, frame.row.values);
      frame.histograms["slack"] = {100, 200, 300 + point};
      block.push_back(frame);
    }
    store_.frames.put(key(point), block);
  }
  void put_all(int count) {
    for (int point = 0; point < points(); ++point) put(point, count);
  }
  /// A picture of each point: a PNG's head, and so many bytes.
  void keep_pictures(std::size_t bytes) const {
    std::filesystem::create_directory(folder_ / "pictures");
    std::ofstream index(folder_ / "pictures/index.csv");
    index << "point,scene,frame,why,file\n";
    for (int point = 0; point < points(); ++point) {
      const std::string file = fmt::format("{}.png", point);
      index << csv_cell(plan_.points[static_cast<std::size_t>(point)].point.name)
            << ",demo,7223,worst," << file << "\n";
      std::ofstream(folder_ / ("pictures/" + file), std::ios::binary)
          << "\x89PNG\r\n\x1a\n"
          << std::string(bytes, char('a' + point % 26));
    }
  }

  std::string page() const { return report_page(SweepReader(folder_.path())); }

 private:
  ScratchFolder folder_;
  SweepPlan plan_;
  Store store_;
  FrameKey key_{};
  std::vector<std::int64_t> ids_{};
};

/// How often a text is in another.
inline std::size_t count_of(const std::string& what, const std::string& in) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = in.find(what, at)) != std::string::npos; at += what.size())
    ++count;
  return count;
}

/// What stands between two texts, the first time.
inline std::string between(const std::string& page, const std::string& begin,
                           const std::string& end) {
  const std::size_t from = page.find(begin);
  if (from == std::string::npos) return "";
  const std::size_t at = from + begin.size();
  return page.substr(at, page.find(end, at) - at);
}

/// The columns that the charts of a page are drawn from.
inline Json data_of(const std::string& page) {
  return Json::parse(between(page, "<script type=\"application/json\" id=\"data\">", "</script>"));
}

/// One of its figures.
inline Json figure_of(const std::string& page, const std::string& name) {
  for (const Json& figure : data_of(page).at("figures").elements())
    if (figure.at("name").get<std::string>() == name) return figure;
  return {};
}

/// A section of the page, by its id.
inline std::string section_of(const std::string& page, const std::string& id) {
  return between(page, "<section id=\"" + id + "\"", "</section>");
}

inline std::size_t rows_of_points(const std::string& page) {
  return count_of("<tr data-point=", page);
}

}  // namespace racebeam
