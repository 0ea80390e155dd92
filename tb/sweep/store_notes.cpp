// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/store_notes.h"

#include "tb/sweep/schema.h"

namespace racebeam {

namespace {

constexpr const char* Now = "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')";

}  // namespace

void FailureTable::put(const FrameKey& key, const std::string& reason) {
  Statement(database_,
            "INSERT INTO failure VALUES (?, ?, ?, ?, 1) ON CONFLICT DO UPDATE SET "
            "reason = excluded.reason, tries = tries + 1")
      .with(key.model, key.scene, key.point, reason)
      .run();
}

void FailureTable::remove(const FrameKey& key) {
  Statement(database_, "DELETE FROM failure WHERE model = ? AND scene = ? AND point = ?")
      .with(key.model, key.scene, key.point)
      .run();
}

std::vector<Failure> FailureTable::all(std::int64_t model) const {
  Statement select(database_,
                   "SELECT scene, point, reason, tries FROM failure WHERE model = ? "
                   "ORDER BY scene, point");
  std::vector<Failure> failures;
  for (select.with(model); select.next();)
    failures.push_back({{model, select.integer(0), select.integer(1)},
                        select.text(2),
                        static_cast<int>(select.integer(3))});
  return failures;
}

void StoppedTable::replace(std::int64_t model, const std::vector<StoppedPoint>& points) {
  Transaction all(database_);
  Statement(database_, "DELETE FROM stopped WHERE model = ?").with(model).run();
  Statement insert(database_, "INSERT INTO stopped VALUES (?, ?, ?, ?, ?)");
  for (const StoppedPoint& point : points)
    insert.with(model, point.point, point.frames, point.by, point.why).run();
  all.commit();
}

std::vector<StoppedPoint> StoppedTable::all(std::int64_t model) const {
  Statement select(database_,
                   "SELECT point, frames, by, why FROM stopped WHERE model = ? "
                   "ORDER BY point");
  std::vector<StoppedPoint> points;
  for (select.with(model); select.next();)
    points.push_back({select.integer(0), static_cast<int>(select.integer(1)), select.integer(2),
                      select.text(3)});
  return points;
}

void ScanTable::put(const FrameKey& key, const std::vector<ScannedFrame>& frames) {
  Transaction all(database_);
  Statement insert(database_, insert_with_digest("scan") + " ON CONFLICT DO NOTHING");
  for (const ScannedFrame& one : frames)
    insert.with(key.model, key.scene, key.point, one.frame, one.busy_max, one.starved).run();
  all.commit();
}

std::vector<ScannedFrame> ScanTable::read(const FrameKey& key) const {
  Statement select(database_,
                   "SELECT frame, busy_max, starved FROM scan "
                   "WHERE model = ? AND scene = ? AND point = ? ORDER BY frame");
  std::vector<ScannedFrame> frames;
  for (select.with(key.model, key.scene, key.point); select.next();)
    frames.push_back({static_cast<int>(select.integer(0)), select.integer(1), select.integer(2)});
  return frames;
}

std::string NoteTable::find(const std::string& name) const {
  Statement select(database_, "SELECT value FROM note WHERE name = ?");
  return select.with(name).next() ? select.text(0) : "";
}

void NoteTable::put(const std::string& name, const std::string& text) {
  Statement(database_,
            "INSERT INTO note VALUES (?, ?) ON CONFLICT DO UPDATE SET value = excluded.value")
      .with(name, text)
      .run();
}

std::int64_t RunTable::begin(const SweepRun& run) {
  Statement(database_, std::string("INSERT INTO run(started, host, cpu, cores, command, tools) "
                                   "VALUES (") +
                           Now + ", ?, ?, ?, ?, ?)")
      .with(run.host, run.cpu, run.cores, run.command, run.tools)
      .run();
  return database_.last_id();
}

void RunTable::end(std::int64_t id, double cpu_seconds) {
  Statement(database_,
            std::string("UPDATE run SET ended = ") + Now + ", cpu_seconds = ? WHERE id = ?")
      .with(cpu_seconds, id)
      .run();
}

std::vector<SweepRun> RunTable::all() const {
  Statement select(database_,
                   "SELECT host, cpu, cores, command, tools, id, started, ended, "
                   "cpu_seconds FROM run ORDER BY id");
  std::vector<SweepRun> runs;
  while (select.next())
    runs.push_back({select.text(0), select.text(1), static_cast<int>(select.integer(2)),
                    select.text(3), select.text(4), select.integer(5), select.text(6),
                    select.text(7), select.real(8)});
  return runs;
}

}  // namespace racebeam
