// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "tb/sweep/columns.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/sweep_changes.h"

namespace racebeam {

namespace {

void write(OutputFile& out, const std::string& text) { out.write(text.data(), text.size()); }

/// The names of all settings, each once, in the order in which they come.
std::vector<std::string> setting_names(const std::vector<StoredPoint>& points) {
  std::vector<std::string> names;
  for (const StoredPoint& point : points)
    for (const auto& [name, value] : setting_of(point.setting))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

std::string setting_cells(const StoredPoint& point, const std::vector<std::string>& names) {
  const auto values = setting_of(point.setting);
  std::string cells;
  for (const std::string& wanted : names) {
    cells += ',';
    for (const auto& [name, value] : values)
      if (name == wanted) cells += csv_cell(value);
  }
  return cells;
}

const StoredPoint& with_id(const std::vector<StoredPoint>& points, std::int64_t id) {
  return *std::find_if(points.begin(), points.end(),
                       [id](const StoredPoint& point) { return point.id == id; });
}

std::string name_of(const StoredPoint& point) {
  return point.name.empty() ? text_hash(point.setting) : point.name;
}

/// Names of scenes by id; of one whose file has changed since its hash.
std::map<std::int64_t, std::string> scene_names(Store& store, std::int64_t model) {
  std::map<std::int64_t, std::string> names, hashes;
  for (const StoredScene& scene : store.scenes()) {
    names[scene.id] = scene.name;
    hashes[scene.id] = scene.hash;
  }
  for (const OlderScene& scene : older_scenes(store, model)) names[scene.id] = hashes[scene.id];
  return names;
}

}  // namespace

void export_points(Store& store, std::int64_t model, OutputFile& out) {
  const std::vector<std::string>& columns = store.frames.columns(model);
  const std::vector<StoredPoint> points = store.points();
  const std::vector<std::string> settings = setting_names(points);
  std::string head = "point,scene", means;
  for (const std::string& name : settings) head += ',' + csv_cell(name);
  head += ",sample_frames,guard_frames";
  const NoValues none(columns);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == PictureColumn) continue;
    head += ',' + csv_cell(columns[i]);
    const std::string some = none.is_some(i, "f");
    means += fmt::format(", avg(f.{}) FILTER (WHERE f.kind = 'sample'{})", quoted(columns[i]),
                         some.empty() ? "" : " AND " + some);
  }
  write(out, head + ",failure\n");
  Statement select(
      store.database(),
      "SELECT k.point, k.scene, count(*) FILTER (WHERE f.kind = 'sample'), "
      "count(*) FILTER (WHERE f.kind = 'guard'), coalesce(x.reason, '')" +
          means +
          " FROM (SELECT DISTINCT model, scene, point FROM frame WHERE model = ?1 "
          "UNION SELECT model, scene, point FROM failure WHERE model = ?1) k "
          "LEFT JOIN frame f ON f.model = k.model AND f.scene = k.scene AND f.point = k.point "
          "LEFT JOIN failure x ON x.model = k.model AND x.scene = k.scene AND x.point = k.point "
          "GROUP BY k.scene, k.point ORDER BY k.scene, k.point");
  std::map<std::int64_t, std::string> scenes = scene_names(store, model);
  for (select.with(model); select.next();) {
    const StoredPoint& point = with_id(points, select.integer(0));
    std::string row = csv_cell(name_of(point)) + ',' + csv_cell(scenes[select.integer(1)]) +
                      setting_cells(point, settings) +
                      fmt::format(",{},{}", select.integer(2), select.integer(3));
    for (int i = 5; i < select.columns(); ++i)
      row += select.kind(i) == Statement::Null ? "," : fmt::format(",{}", select.real(i));
    write(out, row + ',' + csv_cell(select.text(4)) + '\n');
  }
}

void export_frames(Store& store, std::int64_t model, OutputFile& out) {
  const std::vector<std::string>& columns = store.frames.columns(model);
  std::string head = "point,scene,frame,kind,digest";
  for (const std::string& name : columns) head += ',' + csv_cell(name);
  write(out, head + '\n');
  const NoValues none(columns);
  const std::vector<StoredPoint> points = store.points();
  for (const auto& [scene, name] : scene_names(store, model))
    for (const StoredPoint& point : points) {
      const std::string whose = csv_cell(name_of(point)) + ',' + csv_cell(name);
      for (const FrameRow& row : store.frames.read({model, scene, point.id})) {
        std::string text = fmt::format("{},{},{},{:016x}", whose, row.frame,
                                       row.guard ? "guard" : "sample", row.digest);
        for (std::size_t i = 0; i < columns.size(); ++i)
          text += columns[i] == PictureColumn
                      ? fmt::format(",{:016x}", static_cast<std::uint64_t>(row.values[i]))
                  : none.is_none(i, row.values) ? ","
                                                : fmt::format(",{}", row.values[i]);
        write(out, text + '\n');
      }
    }
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

}  // namespace racebeam
