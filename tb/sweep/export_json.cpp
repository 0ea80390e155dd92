// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tb/sweep/columns.h"
#include "tb/sweep/export.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

std::string hexadecimal(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

void write(OutputFile& out, const std::string& text) { out.write(text.data(), text.size()); }

/// A list of values, each on a line of its own, written as they come.
class List {
 public:
  List(OutputFile& out, const char* name) : out_(out) {
    write(out_, fmt::format(",\n\"{}\": [", name));
  }
  // Names need not be UTF-8; JSON must be.
  void add(const Json& value) {
    write(out_, (std::exchange(first_, false) ? "\n" : ",\n") +
                    value.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  void end() { write(out_, "\n]"); }

 private:
  OutputFile& out_;
  bool first_ = true;
};

/// The rows of a query as objects by the names of its columns.
void add_rows(Store& store, OutputFile& out, const char* name, const char* sql) {
  List list(out, name);
  Statement select(store.database(), sql);
  while (select.next()) {
    Json row;
    for (int i = 0; i < select.columns(); ++i) {
      Json& value = row[select.name(i)];
      switch (select.kind(i)) {
        case Statement::Integer: value = select.integer(i); break;
        case Statement::Real: value = select.real(i); break;
        case Statement::Text: value = select.text(i); break;
        default: break;
      }
    }
    list.add(row);
  }
  list.end();
}

void add_models(Store& store, OutputFile& out) {
  List list(out, "models");
  for (const StoredModel& model : store.models())
    list.add({{"id", model.id},
              {"hash", model.hash},
              {"version", model.version},
              {"commit", model.commit},
              {"program", model.program},
              {"compiler", model.compiler},
              {"columns", store.frames.columns(model.id)}});
  list.end();
}

void add_points(Store& store, OutputFile& out) {
  List list(out, "points");
  for (const StoredPoint& point : store.points()) {
    Json setting = Json::object();
    for (const auto& [name, value] : setting_of(point.setting)) setting[name] = value;
    list.add({{"id", point.id},
              {"hash", text_hash(point.setting)},
              {"name", point.name.empty() ? Json() : Json(point.name)},
              {"setting", setting}});
  }
  list.end();
}

/// [frame, kind, digest, value by the model's columns ...]
Json frame_values(const FrameRow& row, const std::vector<std::string>& columns,
                  const NoValues& none) {
  Json values = Json::array({row.frame, row.guard ? "guard" : "sample", hexadecimal(row.digest)});
  for (std::size_t i = 0; i < columns.size(); ++i)
    values.push_back(columns[i] == PictureColumn
                         ? Json(hexadecimal(static_cast<std::uint64_t>(row.values[i])))
                     : none.is_none(i, row.values) ? Json()
                                                   : Json(row.values[i]));
  return values;
}

void add_results(Store& store, OutputFile& out) {
  List list(out, "results");
  const std::vector<StoredPoint> points = store.points();
  for (const StoredModel& model : store.models()) {
    const std::vector<std::string>& columns = store.frames.columns(model.id);
    const NoValues none(columns);
    for (const StoredScene& scene : store.scenes())
      for (const StoredPoint& point : points) {
        const FrameKey key{model.id, scene.id, point.id};
        Json frames = Json::array(), histograms = Json::object();
        for (const FrameRow& row : store.frames.read(key))
          frames.push_back(frame_values(row, columns, none));
        if (frames.empty()) continue;
        for (const auto& [name, histogram] : store.frames.histograms(key))
          histograms[name] = {{"frames", histogram.frames}, {"bins", histogram.bins}};
        list.add({{"model", model.id},
                  {"scene", scene.id},
                  {"point", point.id},
                  {"frames", frames},
                  {"histograms", histograms}});
      }
  }
  list.end();
}

}  // namespace

void export_json(Store& store, OutputFile& out) {
  write(out, fmt::format("{{\"schema\": \"{}\",\n\"version\": {}", SchemaName, SchemaVersion));
  add_models(store, out);
  add_rows(store, out, "scenes", "SELECT id, name, hash, frames FROM scene ORDER BY id");
  add_points(store, out);
  add_results(store, out);
  add_rows(store, out, "causes", "SELECT model, scene, point, frame, cause, pixels FROM cause");
  add_rows(store, out, "failures", "SELECT * FROM failure");
  add_rows(store, out, "stopped", "SELECT * FROM stopped");
  add_rows(store, out, "units",
           "SELECT hash, unit, parameters, recipe, flip_flops, cells, area FROM unit");
  add_rows(store, out, "chips",
           "SELECT hash, top, parameters, technology, flip_flops, cells, area, multipliers, ns, "
           "from_register, to_register FROM chip");
  add_rows(store, out, "disputed", "SELECT model, scene, point, frame, figures FROM disputed");
  add_rows(store, out, "runs", "SELECT * FROM run ORDER BY id");
  write(out, "\n}\n");
}

}  // namespace racebeam
