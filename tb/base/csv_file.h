// CsvFile: a table of comma-separated values, read row by row, with errors that name the place.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace racebeam {

/// Blanks around values and empty lines do not count; there is no quoting.
class CsvFile {
 public:
  /// Reads the header line, which must name these columns in this order. Throws UsageError.
  CsvFile(const std::string& path, std::vector<std::string> columns);

  /// Goes to the next row. False at the end of the file. Throws UsageError unless the row has a
  /// value for each column.
  bool next();

  /// A value of this row.
  const std::string& text(std::size_t column) const { return cells_[column].text; }
  /// The same as a number, decimal or 0x..., in this range. Throws UsageError.
  long long number(std::size_t column, long long min, long long max) const;
  /// Line of the file, from 1.
  int line() const { return line_; }

  /// Throws UsageError "FILE:LINE:COLUMN: NAME WHAT", of a value of this row.
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

 private:
  struct Cell {
    std::string text;
    std::size_t at;  ///< column of the file, from 1
  };
  bool read_line();
  [[noreturn]] void fail_at(std::size_t at, const std::string& what) const;

  const std::string path_;
  const std::vector<std::string> columns_;
  std::ifstream in_;
  std::vector<Cell> cells_;
  int line_ = 0;
};

}  // namespace racebeam
