// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/schema.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <strings.h>
#include <sys/vfs.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "tb/base/errors.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

// The columns of frame that are no figures.
constexpr const char* OwnColumns[] = {"model", "scene", "point", "frame", "kind", "digest"};

constexpr const char* Tables = R"(
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT;
-- columns: of frame, one a line
CREATE TABLE model(id INTEGER PRIMARY KEY, hash TEXT UNIQUE NOT NULL, version TEXT, commit_id TEXT,
  program TEXT, compiler TEXT, columns TEXT NOT NULL) STRICT;
CREATE TABLE scene(id INTEGER PRIMARY KEY, name TEXT, hash TEXT UNIQUE NOT NULL, frames INTEGER)
  STRICT;
-- hash: of setting, all that a result depends on but model, scene and frame: "name=value\n", sorted.
-- name: NULL if the sweep has no such point any more
CREATE TABLE point(id INTEGER PRIMARY KEY, hash TEXT UNIQUE NOT NULL, setting TEXT NOT NULL,
  name TEXT) STRICT;
CREATE TABLE frame(model INTEGER REFERENCES model, scene INTEGER REFERENCES scene,
  point INTEGER REFERENCES point, frame INTEGER, kind TEXT CHECK(kind IN ('sample', 'guard')),
  digest INTEGER NOT NULL, PRIMARY KEY(model, scene, point, frame)) STRICT, WITHOUT ROWID;
-- What was measured twice and differs; figures: "name=value\n" of the columns
CREATE TABLE disputed(model INTEGER REFERENCES model, scene INTEGER REFERENCES scene,
  point INTEGER REFERENCES point, frame INTEGER, digest INTEGER, figures TEXT NOT NULL,
  PRIMARY KEY(model, scene, point, frame, digest)) STRICT, WITHOUT ROWID;
-- bins: 64 bits each, the lowest byte first; the sum over so many sample frames
CREATE TABLE histogram(model INTEGER REFERENCES model, scene INTEGER REFERENCES scene,
  point INTEGER REFERENCES point, name TEXT, frames INTEGER NOT NULL, bins BLOB NOT NULL,
  digest INTEGER NOT NULL, PRIMARY KEY(model, scene, point, name)) STRICT;
CREATE TABLE cause(model INTEGER REFERENCES model, scene INTEGER REFERENCES scene,
  point INTEGER REFERENCES point, frame INTEGER, cause TEXT, pixels INTEGER NOT NULL,
  digest INTEGER NOT NULL, PRIMARY KEY(model, scene, point, frame, cause)) STRICT, WITHOUT ROWID;
CREATE TABLE unit(hash TEXT PRIMARY KEY, unit TEXT, parameters TEXT, recipe TEXT,
  flip_flops INTEGER, cells INTEGER, area REAL, digest INTEGER NOT NULL) STRICT;
-- picture: packed colours; of a link of errors by cause, zlib of a bit a pixel
CREATE TABLE reference(hash TEXT PRIMARY KEY, picture BLOB NOT NULL,
  digest INTEGER NOT NULL) STRICT;
CREATE TABLE failure(model INTEGER REFERENCES model, scene INTEGER REFERENCES scene,
  point INTEGER REFERENCES point, reason TEXT NOT NULL, tries INTEGER NOT NULL,
  PRIMARY KEY(model, scene, point)) STRICT;
CREATE TABLE stopped(model INTEGER REFERENCES model, point INTEGER REFERENCES point,
  frames INTEGER NOT NULL, by INTEGER REFERENCES point(id), why TEXT NOT NULL,
  PRIMARY KEY(model, point)) STRICT;
-- the base's frames: which are the worst
CREATE TABLE scan(model INTEGER REFERENCES model, scene INTEGER REFERENCES scene,
  point INTEGER REFERENCES point, frame INTEGER, busy_max INTEGER NOT NULL,
  starved INTEGER NOT NULL, digest INTEGER NOT NULL,
  PRIMARY KEY(model, scene, point, frame)) STRICT, WITHOUT ROWID;
CREATE TABLE note(name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT;
CREATE TABLE run(id INTEGER PRIMARY KEY, started TEXT NOT NULL, ended TEXT, host TEXT, cpu TEXT,
  cores INTEGER, command TEXT, tools TEXT, cpu_seconds REAL) STRICT;
)";

std::vector<std::string> columns_of_frame(Database& database) {
  std::vector<std::string> names;
  Statement info(database, "SELECT name FROM pragma_table_info('frame')");
  while (info.next()) names.push_back(info.text(0));
  return names;
}

// A whole chip, mapped to a technology; ns: its longest path. Stores of before have no such table.
constexpr const char* Chips = R"(TABLE chip(hash TEXT PRIMARY KEY, top TEXT, parameters TEXT,
  technology TEXT, flip_flops INTEGER, cells INTEGER, area REAL, multipliers REAL, ns REAL,
  from_register TEXT, to_register TEXT, digest INTEGER NOT NULL) STRICT;
)";

bool has_chips(Database& database) {
  Statement tables(database, "SELECT 1 FROM sqlite_schema WHERE name = 'chip'");
  return tables.next();
}

/// One row a point that was measured or failed, for people: the means of its sample.
void make_view(Database& database) {
  std::string means;
  for (const std::string& name : columns_of_frame(database))
    if (name != PictureColumn &&
        std::find(std::begin(OwnColumns), std::end(OwnColumns), name) == std::end(OwnColumns))
      means += fmt::format(", avg(f.{0}) AS {0}", quoted(name));
  database.run(
      "DROP VIEW IF EXISTS points; CREATE VIEW points AS "
      "SELECT p.name AS point, s.name AS scene, m.hash AS model, "
      "count(f.frame) AS frames" +
      means +
      ", x.reason AS failure "
      "FROM (SELECT DISTINCT model, scene, point FROM frame "
      "UNION SELECT model, scene, point FROM failure) k "
      "JOIN model m ON m.id = k.model JOIN scene s ON s.id = k.scene "
      "JOIN point p ON p.id = k.point "
      "LEFT JOIN frame f ON f.model = k.model AND f.scene = k.scene "
      "AND f.point = k.point AND f.kind = 'sample' "
      "LEFT JOIN failure x ON x.model = k.model AND x.scene = k.scene "
      "AND x.point = k.point GROUP BY k.model, k.scene, k.point");
}

std::string meta(Database& database, const char* key) {
  Statement tables(database, "SELECT 1 FROM sqlite_schema WHERE name = 'meta'");
  if (!tables.next()) return "";
  try {
    Statement value(database, "SELECT value FROM meta WHERE key = ?");
    return value.with(key).next() ? value.text(0) : "";
  } catch (const UsageError&) {
    throw;
  } catch (const std::runtime_error&) {
    return "";  // a table of this name of somebody else
  }
}

void check_version(Database& database) {
  const std::string version = meta(database, "version");
  int number = 0;
  const char* const end = version.data() + version.size();
  const auto [stop, error] = std::from_chars(version.data(), end, number);
  if (meta(database, "schema") != SchemaName || stop != end || error != std::errc{} || number < 1)
    throw UsageError(database.file() + " is not the store of a sweep; name another folder");
  if (number > SchemaVersion)
    throw UsageError(
        fmt::format("{} is of a newer racebeam: version {} of {}, this one knows {}; "
                    "use that program, or name another folder",
                    database.file(), number, SchemaName, SchemaVersion));
}

bool empty(Database& database) {
  Statement tables(database, "SELECT count(*) FROM sqlite_schema");
  return tables.next() && tables.integer(0) == 0;
}

}  // namespace

Journal journal_on(std::uint64_t type) {
  constexpr std::uint64_t Shared[] = {
      0x6969,                              // NFS
      0x517b,     0xff534d42, 0xfe534d42,  // SMB, CIFS, SMB 2
      0x0bd00bd0, 0x47504653,              // Lustre, GPFS
      0x00c36400, 0x19830326,              // Ceph, BeeGFS
      0x01021997, 0x65735546,              // 9P, FUSE: what is behind them is not known
  };
  return std::find(std::begin(Shared), std::end(Shared), type) != std::end(Shared)
             ? Journal::Rollback
             : Journal::Log;
}

Journal journal_in(const std::string& folder) {
  struct statfs facts {};
  if (statfs(folder.c_str(), &facts) != 0) return Journal::Rollback;
  return journal_on(static_cast<std::uint32_t>(facts.f_type));
}

void open_schema(Database& database, Journal journal) {
  const bool fresh = empty(database);
  if (!fresh) check_version(database);
  if (!database.writes()) {
    if (fresh) throw UsageError(database.file() + " is empty: no sweep has begun there");
    if (!has_chips(database))
      database.run(std::string("PRAGMA query_only = 0; CREATE TEMP ") + Chips +
                   "PRAGMA query_only = 1");
    return;
  }
  database.run(journal == Journal::Log ? "PRAGMA journal_mode = WAL"
                                       : "PRAGMA journal_mode = DELETE");
  database.run("PRAGMA synchronous = FULL");
  if (!fresh && !has_chips(database)) database.run(std::string("CREATE ") + Chips);
  if (!fresh) return;
  Transaction all(database);
  database.run(std::string(Tables) + "CREATE " + Chips);
  Statement meta(database, "INSERT INTO meta(key, value) VALUES (?, ?)");
  meta.with("schema", SchemaName).run();
  meta.with("version", std::to_string(SchemaVersion)).run();
  make_view(database);
  all.commit();
}

void add_columns(Database& database, const std::vector<std::string>& columns) {
  const std::vector<std::string> there = columns_of_frame(database);
  std::vector<std::string> names(std::begin(OwnColumns), std::end(OwnColumns));
  for (const std::string& name : columns) {
    const auto same = [&name](const std::string& other) {
      return strcasecmp(other.c_str(), name.c_str()) == 0;
    };
    if (name.empty() || name.find('\n') != std::string::npos ||
        std::any_of(names.begin(), names.end(), same))
      throw std::invalid_argument("a column of frames cannot be called '" + name + "'");
    names.push_back(name);
    if (std::none_of(there.begin(), there.end(), same))
      database.run("ALTER TABLE frame ADD COLUMN " + quoted(name) + " INTEGER");
  }
  make_view(database);
}

const std::vector<DigestedTable>& digested_tables() {
  static const std::vector<DigestedTable> tables = {
      {"histogram", "model, scene, point, name, frames, bins"},
      {"cause", "model, scene, point, frame, cause, pixels"},
      {"unit", "hash, unit, parameters, recipe, flip_flops, cells, area"},
      {"chip",
       "hash, top, parameters, technology, flip_flops, cells, area, multipliers, ns, "
       "from_register, to_register"},
      {"reference", "hash, picture"},
      {"scan", "model, scene, point, frame, busy_max, starved"},
  };
  return tables;
}

std::string insert_with_digest(std::string_view table) {
  for (const DigestedTable& row : digested_tables()) {
    if (table != row.name) continue;
    const std::string_view columns = row.columns;
    std::vector<std::string> places;
    for (int at = 0; at <= std::count(columns.begin(), columns.end(), ','); ++at)
      places.push_back("?" + std::to_string(at + 1));
    return fmt::format("INSERT INTO {0}({1}, digest) VALUES ({2}, digest({2}))", table, columns,
                       fmt::join(places, ", "));
  }
  throw std::invalid_argument("no table with digests: " + std::string(table));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::pair<std::string, std::string>> setting_of(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const std::string& line : lines_of(text)) {
    const std::size_t equals = std::min(line.find('='), line.size());
    values.emplace_back(line.substr(0, equals), line.substr(std::min(equals + 1, line.size())));
  }
  return values;
}

}  // namespace racebeam
