// The tables of a sweep's store, and what makes a file one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/sweep/database.h"

namespace racebeam {

constexpr const char* SchemaName = "racebeam-sweep";
constexpr int SchemaVersion = 1;

/// How SQLite keeps a transaction whole.
enum class Journal {
  Log,       ///< WAL: readers do not disturb; they share memory with the writer
  Rollback,  ///< needs nothing but locks
};

/// What fits the type of a file system, as of statfs().
Journal journal_on(std::uint64_t type);
/// What fits the file system of this folder.
Journal journal_in(const std::string& folder);

/// Makes the tables in an empty file, or looks whether they are those of this version. Throws
/// UsageError of a file of something else or of a newer version, and what Database throws; then
/// nothing is changed.
void open_schema(Database& database, Journal journal);

/// Gives the table of frames these columns, and the view `points` their means. Throws
/// std::invalid_argument of names that cannot be columns.
void add_columns(Database& database, const std::vector<std::string>& columns);

/// A table whose rows have a digest of the columns named here, in this order.
struct DigestedTable {
  const char* name;
  const char* columns;
};
/// All of them but frame, whose digest is of its own kind.
const std::vector<DigestedTable>& digested_tables();
/// "INSERT INTO name(columns, digest) VALUES (?1, ..., digest(?1, ...))"
std::string insert_with_digest(std::string_view table);

/// The names in a text with one a line.
std::vector<std::string> lines_of(const std::string& text);
/// Names and values in a text of lines "name=value".
std::vector<std::pair<std::string, std::string>> setting_of(const std::string& text);

}  // namespace racebeam
