// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "tb/base/output_file.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/store_errors.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr int Patience = 10'000;  // milliseconds, for another program that has the file
constexpr const char* ReadOnly = "it can only be read";

/// For files where nothing can be written: SQLite then looks for no lock, and makes no other file.
std::string as_immutable(const std::string& file) {
  std::string name = "file:";
  for (const char c : fs::absolute(file).string())
    name += std::isalnum(static_cast<unsigned char>(c)) || std::strchr("/._-", c)
                ? std::string(1, c)
                : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return name + "?immutable=1";
}

/// A run that was killed has left what is not in the file yet, or must be undone.
bool was_left(const std::string& file) {
  const auto has = [&file](const char* end) {
    std::error_code error;
    const auto size = fs::file_size(file + end, error);
    return !error && size > 0;
  };
  return has("-wal") || has("-journal");
}

}  // namespace

Database::Database(const std::string& file, Access access) : file_(file), access_(access) {
  int code =
      connect(file, writes() ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY);
  const int why = code & 0xff;
  if (!writes() && (why == SQLITE_CANTOPEN || why == SQLITE_READONLY)) {
    sqlite3_close(std::exchange(handle_, nullptr));
    code = was_left(file) ? connect(file, SQLITE_OPEN_READWRITE)
                          : connect(as_immutable(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  }
  try {
    if ((code & 0xff) == SQLITE_ERROR) fail(SQLITE_CORRUPT);
    if (code != SQLITE_OK) fail(code);
    if (writes() && sqlite3_db_readonly(handle_, "main") == 1) throw OutputError(file_, ReadOnly);
  } catch (...) {
    sqlite3_close(handle_);
    throw;
  }
}

// The file itself is opened when it is first read.
int Database::connect(const std::string& name, int flags) {
  if (const int code =
          sqlite3_open_v2(name.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, nullptr);
      code != SQLITE_OK)
    return code;
  sqlite3_extended_result_codes(handle_, 1);
  sqlite3_busy_timeout(handle_, Patience);
  // A name that is not there is an error, and no text.
  for (const int option : {SQLITE_DBCONFIG_DQS_DML, SQLITE_DBCONFIG_DQS_DDL})
    sqlite3_db_config(handle_, option, 0, nullptr);
  add_digest_function(handle_);
  const std::string begin = fmt::format(
      "PRAGMA foreign_keys = ON; PRAGMA query_only = {}; SELECT count(*) FROM sqlite_schema",
      !writes());
  return sqlite3_exec(handle_, begin.c_str(), nullptr, nullptr, nullptr);
}

Database::~Database() {
  if (writes()) {
    sqlite3_busy_timeout(handle_, 0);
    sqlite3_exec(handle_, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
  }
  sqlite3_close(handle_);
}

std::string Database::folder() const {
  const std::string parent = fs::path(file_).parent_path().string();
  return parent.empty() ? "." : parent;
}

void Database::run(const std::string& sql) {
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

std::int64_t Database::changes() const { return sqlite3_changes64(handle_); }
std::int64_t Database::last_id() const { return sqlite3_last_insert_rowid(handle_); }

void Database::fail(int code) const {
  const int system = sqlite3_system_errno(handle_);
  const std::string what = sqlite3_errmsg(handle_);
  switch (code & 0xff) {
    case SQLITE_FULL: throw DiskFull(folder());
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB: throw DamagedStore(file_, folder(), what);
    case SQLITE_BUSY:
      throw UsageError(file_ +
                       " is in use by another program; run the same command again when "
                       "that has ended");
    case SQLITE_READONLY:
      if (writes()) throw OutputError(file_, ReadOnly);
      throw UsageError("cannot read " + file_ +
                       ": a run that was killed has left it, and it can "
                       "be put in order only where it can be written");
    case SQLITE_CANTOPEN:
    case SQLITE_IOERR:
      if (system == ENOSPC || system == EDQUOT) throw DiskFull(folder());
      if (writes()) throw OutputError(file_, system, what);
      throw UsageError("cannot read " + file_ + ": " + (system ? std::strerror(system) : what));
    default: throw std::runtime_error(file_ + ": " + what);
  }
}

Statement::Statement(Database& database, const std::string& sql) : database_(database) {
  const int code = sqlite3_prepare_v3(database.handle(), sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &handle_, nullptr);
  if (code != SQLITE_OK) database.fail(code);
}

Statement::Statement(Statement&& other) noexcept
    : database_(other.database_), handle_(std::exchange(other.handle_, nullptr)) {}

Statement::~Statement() { sqlite3_finalize(handle_); }

void Statement::bind(int at, std::int64_t value) { sqlite3_bind_int64(handle_, at, value); }
void Statement::bind(int at, double value) { sqlite3_bind_double(handle_, at, value); }

void Statement::bind(int at, std::string_view text) {
  sqlite3_bind_text64(handle_, at, text.empty() ? "" : text.data(), text.size(), SQLITE_STATIC,
                      SQLITE_UTF8);
}

void Statement::bind_blob(int at, std::string_view bytes) {
  sqlite3_bind_blob64(handle_, at, bytes.empty() ? "" : bytes.data(), bytes.size(), SQLITE_STATIC);
}

bool Statement::next() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  reset();
  if (code != SQLITE_DONE) database_.fail(code);
  return false;
}

void Statement::reset() { sqlite3_reset(handle_); }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }
double Statement::real(int column) const { return sqlite3_column_double(handle_, column); }

std::string_view Statement::view(int column) const {
  const void* data = sqlite3_column_blob(handle_, column);  // first: it may change what follows
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, column));
  return data ? std::string_view(static_cast<const char*>(data), size) : "";
}

Statement::Kind Statement::kind(int column) const {
  switch (sqlite3_column_type(handle_, column)) {
    case SQLITE_INTEGER: return Integer;
    case SQLITE_FLOAT: return Real;
    case SQLITE_TEXT: return Text;
    case SQLITE_BLOB: return Blob;
    default: return Null;
  }
}

int Statement::columns() const { return sqlite3_column_count(handle_); }
std::string Statement::name(int column) const { return sqlite3_column_name(handle_, column); }

Transaction::Transaction(Database& database)
    : database_(database), outer_(sqlite3_get_autocommit(database.handle())) {
  if (outer_) database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (outer_ && !sqlite3_get_autocommit(database_.handle()))
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  if (outer_) database_.run("COMMIT");
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

}  // namespace racebeam
