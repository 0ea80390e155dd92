// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/store_check.h"

#include <fmt/format.h>

#include <functional>
#include <optional>

#include "tb/base/whole_file.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/store.h"
#include "tb/sweep/store_errors.h"

namespace racebeam {

namespace {

constexpr std::size_t Told = 100;  // faults of a kind

/// What is read as far as it goes: a table that cannot be read is a fault, and no end.
class Check {
 public:
  Check(Database& database, StoreReport& report) : database_(database), report_(report) {}

  void integrity() {
    each(fmt::format("PRAGMA integrity_check({})", Told), "the file", [this](const Statement& row) {
      if (row.text(0) != "ok") fault(row.text(0));
    });
    each("PRAGMA foreign_key_check", "the keys", [this](const Statement& row) {
      fault(fmt::format("a row of {} is of something that is not in {}", row.text(0), row.text(2)));
    });
  }

  void count_rows() {
    std::vector<std::string> names;
    each("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name", "the tables",
         [&names](const Statement& row) { names.push_back(row.text(0)); });
    for (const std::string& name : names)
      each("SELECT 1 FROM " + quoted(name), "table " + name,
           [this, &name](const Statement&) { ++report_.rows[name]; });
  }

  void points() {
    each("SELECT id, hash, setting FROM point", "table point", [this](const Statement& row) {
      if (text_hash(row.text(2)) != row.text(1))
        fault(fmt::format("the setting of point {} does not have its hash", row.integer(0)));
    });
  }

  void digests() {
    for (const DigestedTable& table : digested_tables())
      each(fmt::format("SELECT {1} FROM {0} WHERE digest IS NOT digest({1})", table.name,
                       table.columns),
           std::string("table ") + table.name, [this, &table](const Statement& row) {
             std::string key;
             for (int i = 0; i < std::min(row.columns(), 4); ++i)
               key += (i ? ", " : "") + row.text(i);
             fault(fmt::format("the row of {} with {} = {} does not have its digest", table.name,
                               table.columns, key));
           });
  }

  void frames() {
    struct Model {
      std::int64_t id;
      std::string hash, columns;
    };
    std::vector<Model> models;
    each("SELECT id, hash, columns FROM model", "table model", [&models](const Statement& row) {
      models.push_back({row.integer(0), row.text(1), row.text(2)});
    });
    for (const Model& model : models) frames_of(model.id, model.columns);
  }

 private:
  void frames_of(std::int64_t model, const std::string& columns) {
    std::string list;
    for (const std::string& name : lines_of(columns)) list += ", f." + quoted(name);
    each(fmt::format("SELECT coalesce(p.name, p.hash), s.name, f.frame, f.digest{} FROM frame f "
                     "LEFT JOIN point p ON p.id = f.point LEFT JOIN scene s ON s.id = f.scene "
                     "WHERE f.model = {}",
                     list, model),
         "table frame", [this](const Statement& row) {
           std::vector<std::int64_t> values;
           bool whole = true;
           for (int i = 4; i < row.columns(); ++i) {
             values.push_back(row.integer(i));
             whole = whole && row.kind(i) != Statement::Null;
           }
           const auto frame = static_cast<int>(row.integer(2));
           if (!whole || static_cast<std::uint64_t>(row.integer(3)) != frame_digest(frame, values))
             fault(fmt::format("frame {} of {} in {} does not have its digest", frame, row.text(0),
                               row.text(1)));
         });
  }

  void each(const std::string& sql, const std::string& what,
            const std::function<void(const Statement&)>& take) {
    try {
      Statement select(database_, sql);
      while (select.next()) take(select);
    } catch (const std::exception& error) {
      fault(what + " cannot be read to its end: " + error.what());
    }
  }

  void fault(const std::string& text) { report_.faults.push_back(text); }

  Database& database_;
  StoreReport& report_;
};

}  // namespace

StoreReport check_store(const std::string& file) {
  StoreReport report;
  try {
    Database database(file, Access::Read);
    open_schema(database, Journal::Rollback);
    Check check(database, report);
    check.integrity();
    check.count_rows();
    check.points();
    check.digests();
    check.frames();
  } catch (const DamagedStore& damage) {
    report.faults.push_back(damage.what());
  }
  return report;
}

}  // namespace racebeam
