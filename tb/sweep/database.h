// Database: an SQLite file, its statements and transactions, with errors that name the file.
//
// A connection must not cross a fork, and is one thread's.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace racebeam {

enum class Access { Read, Write };

/// Everything here that works with the file throws DiskFull, DamagedStore, OutputError where it
/// cannot be written, UsageError if it is locked or cannot be read, and std::runtime_error of SQL
/// that is wrong.
class Database {
 public:
  /// To write, makes it if need be. What only reads works beside a writer, and where nothing can be
  /// written.
  Database(const std::string& file, Access access);
  /// A file that was written becomes one that is whole without others beside it, if nobody reads
  /// it.
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::string& file() const { return file_; }
  /// The folder of the file, "." if its name has none.
  std::string folder() const;
  bool writes() const { return access_ == Access::Write; }

  /// One statement or more, without values and results.
  void run(const std::string& sql);
  /// Rows that the last INSERT, UPDATE or DELETE has changed.
  std::int64_t changes() const;
  /// Id of the last row that was inserted.
  std::int64_t last_id() const;

  sqlite3* handle() const { return handle_; }
  /// What an SQLite code other than good means.
  [[noreturn]] void fail(int code) const;

 private:
  int connect(const std::string& name, int flags);

  const std::string file_;
  const Access access_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. It must not outlive its database.
class Statement {
 public:
  Statement(Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  Statement(Statement&& other) noexcept;

  /// Begins anew with these values: integers, double, text. Text must live until the last next().
  template <class... Values>
  Statement& with(const Values&... values) {
    reset();
    int at = 0;
    (bind(++at, values), ...);
    return *this;
  }
  void bind(int at, std::int64_t value);
  void bind(int at, int value) { bind(at, static_cast<std::int64_t>(value)); }
  void bind(int at, double value);
  void bind(int at, std::string_view text);
  void bind(int at, const std::string& text) { bind(at, std::string_view(text)); }
  void bind(int at, const char* text) { bind(at, std::string_view(text)); }
  void bind_blob(int at, std::string_view bytes);

  /// Goes to the next row. False at the end; from then on it can begin anew.
  bool next();
  /// For statements without rows.
  void run() {
    while (next()) {
    }
  }
  void reset();

  /// Values of this row, by column from 0.
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const { return std::string(view(column)); }
  /// A text or a blob, until the next row; "": NULL.
  std::string_view view(int column) const;
  enum Kind { Null, Integer, Real, Text, Blob };
  Kind kind(int column) const;
  int columns() const;
  std::string name(int column) const;

 private:
  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

/// All of it or nothing: what was not committed is undone in the end. Inside of another one it is a
/// part of that.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  /// From here on it is on the disk.
  void commit();

 private:
  Database& database_;
  const bool outer_;
};

/// A name as SQL writes it.
std::string quoted(const std::string& name);

}  // namespace racebeam
