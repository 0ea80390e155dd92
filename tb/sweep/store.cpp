// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/store.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tb/base/errors.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

Store::Store(const std::string& file, Access access, Journal journal) : database_(file, access) {
  open_schema(database_, journal);
}

Store::Store(const std::string& file, Access access) : database_(file, access) {
  open_schema(database_, journal_in(database_.folder()));
}

std::int64_t Store::model(const StoredModel& model, const std::vector<std::string>& columns) {
  Statement find(database_, "SELECT id, columns FROM model WHERE hash = ?");
  if (find.with(model.hash).next()) {
    if (lines_of(find.text(1)) != columns)
      throw UsageError(
          fmt::format("{} has frames of the same model, {}, with other figures than "
                      "this program measures; name another folder",
                      database_.file(), model.hash));
    return find.integer(0);
  }
  Transaction all(database_);
  add_columns(database_, columns);
  Statement insert(database_,
                   "INSERT INTO model(hash, version, commit_id, program, compiler, "
                   "columns) VALUES (?, ?, ?, ?, ?, ?)");
  const std::string lines = fmt::format("{}\n", fmt::join(columns, "\n"));
  insert.with(model.hash, model.version, model.commit, model.program, model.compiler, lines).run();
  const std::int64_t id = database_.last_id();
  all.commit();
  return id;
}

std::int64_t Store::scene(const StoredScene& scene) {
  Statement find(database_, "SELECT id, name FROM scene WHERE hash = ?");
  if (find.with(scene.hash).next()) {
    const std::int64_t id = find.integer(0);
    const bool renamed = find.text(1) != scene.name;
    find.reset();
    if (renamed)
      Statement(database_, "UPDATE scene SET name = ? WHERE id = ?").with(scene.name, id).run();
    return id;
  }
  Statement insert(database_, "INSERT INTO scene(name, hash, frames) VALUES (?, ?, ?)");
  insert.with(scene.name, scene.hash, scene.frames).run();
  return database_.last_id();
}

std::vector<std::int64_t> Store::points(const std::vector<StoredPoint>& points) {
  std::vector<std::int64_t> ids;
  Transaction all(database_);
  Statement find(database_, "SELECT id FROM point WHERE hash = ?");
  Statement insert(database_, "INSERT INTO point(hash, setting) VALUES (?, ?)");
  Statement(database_, "UPDATE point SET name = NULL").run();
  Statement rename(database_, "UPDATE point SET name = nullif(?, '') WHERE id = ?");
  for (const StoredPoint& point : points) {
    const std::string hash = text_hash(point.setting);
    if (find.with(hash).next()) {
      ids.push_back(find.integer(0));
      find.reset();
    } else {
      insert.with(hash, point.setting).run();
      ids.push_back(database_.last_id());
    }
    rename.with(point.name, ids.back()).run();
  }
  all.commit();
  return ids;
}

std::vector<StoredModel> Store::models() {
  Statement select(database_,
                   "SELECT hash, version, commit_id, program, compiler, id FROM model "
                   "ORDER BY id");
  std::vector<StoredModel> models;
  while (select.next())
    models.push_back({select.text(0), select.text(1), select.text(2), select.text(3),
                      select.text(4), select.integer(5)});
  return models;
}

std::vector<StoredScene> Store::scenes() {
  Statement select(database_, "SELECT name, hash, frames, id FROM scene ORDER BY id");
  std::vector<StoredScene> scenes;
  while (select.next())
    scenes.push_back({select.text(0), select.text(1), select.integer(2), select.integer(3)});
  return scenes;
}

std::vector<StoredPoint> Store::points() {
  Statement select(database_, "SELECT setting, coalesce(name, ''), id FROM point ORDER BY id");
  std::vector<StoredPoint> points;
  while (select.next()) points.push_back({select.text(0), select.text(1), select.integer(2)});
  return points;
}

}  // namespace racebeam
