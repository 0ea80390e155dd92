// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/csv_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr const char* Blanks = " \t\r";

}  // namespace

CsvFile::CsvFile(const std::string& path, std::vector<std::string> columns)
    : path_(path), columns_(std::move(columns)), in_(path) {
  std::error_code error;
  if (!in_ || std::filesystem::is_directory(path_, error))
    throw UsageError(path_ + " cannot be read");
  std::vector<std::string> names;
  const bool any = read_line();
  for (const Cell& cell : cells_) names.push_back(cell.text);
  if (!any || names != columns_)
    fail_at(1, fmt::format("the first line must be `{}`", fmt::join(columns_, ",")));
}

// The next line that is not empty, as cells.
bool CsvFile::read_line() {
  cells_.clear();
  std::string line;
  do {
    if (!std::getline(in_, line)) return false;
    ++line_;
  } while (line.find_first_not_of(Blanks) == std::string::npos);
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::size_t first = std::min(line.find_first_not_of(Blanks, begin), end);
    const std::string_view value = std::string_view(line).substr(first, end - first);
    const std::size_t last = value.find_last_not_of(Blanks);
    cells_.push_back({std::string(value.substr(0, last + 1)), first + 1});
    begin = end + 1;
  }
  return true;
}

bool CsvFile::next() {
  if (!read_line()) return false;
  if (cells_.size() != columns_.size())
    fail_at(1, fmt::format("{} values instead of {}: {}", cells_.size(), columns_.size(),
                           fmt::join(columns_, ",")));
  return true;
}

long long CsvFile::number(std::size_t column, long long min, long long max) const {
  const std::string& word = text(column);
  const bool hex = word.rfind("0x", 0) == 0 || word.rfind("0X", 0) == 0;
  const char *begin = word.data() + (hex ? 2 : 0), *const end = word.data() + word.size();
  long long value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value, hex ? 16 : 10);
  if (error == std::errc::invalid_argument || stop != end || (hex && *begin == '-'))
    fail(column, fmt::format("is '{}', must be a number, {}..{}", word, min, max));
  if (error != std::errc{} || value < min || value > max)
    fail(column, fmt::format("is {}, must be {}..{}", word, min, max));
  return value;
}

void CsvFile::fail(std::size_t column, const std::string& what) const {
  fail_at(cells_[column].at, columns_[column] + " " + what);
}

void CsvFile::fail_at(std::size_t at, const std::string& what) const {
  throw UsageError(fmt::format("{}:{}:{}: {}", path_, line_, at, what));
}

}  // namespace racebeam
