// The knobs of any engine: the rows of its table, and a whole number for each.
//
// An engine has its knobs as a plain struct of ints and names them in a table of knob_of<struct>.
// What works with any engine passes them as knob_values and asks the rows.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace racebeam {

/// One row of a table of knobs.
struct knob_row {
  const char* name;
  int min, max;
  std::vector<std::string> names;  ///< names of the values min..max, if they are names
  const char* unit;
  const char* meaning;
  const char* source;
  bool of_scene = false;      ///< a scene file sets it, and nobody else
  const char* model_of = "";  ///< unit of which only the model has other values than the chip's
  int standard = 0;           ///< of the chip as it was built; rows_of() finds it in the struct

  /// "4", or the name of the value where values have names.
  std::string text(int value) const;
  /// "1..64", or the names.
  std::string range() const;
};

/// The same with its place in the struct of an engine.
template <class Knobs>
struct knob_of : knob_row {
  int Knobs::*member;
};

class knob_values {
 public:
  /// Of no engine: no rows.
  knob_values() = default;
  /// `rows` outlives it; one value for each.
  knob_values(const std::vector<knob_row>& rows, std::vector<int> values);

  const std::vector<knob_row>& rows() const { return *rows_; }
  int operator[](std::size_t row) const { return values_[row]; }
  int& operator[](std::size_t row) { return values_[row]; }
  /// By its name. Throws std::out_of_range.
  int of(const std::string& name) const;

  bool operator==(const knob_values& o) const { return rows_ == o.rows_ && values_ == o.values_; }
  bool operator!=(const knob_values& o) const { return !(*this == o); }

 private:
  static const std::vector<knob_row> none;

  const std::vector<knob_row>* rows_ = &none;
  std::vector<int> values_;
};

/// The rows of an engine's table.
template <class Knobs>
std::vector<knob_row> rows_of(const std::vector<knob_of<Knobs>>& table) {
  std::vector<knob_row> rows(table.begin(), table.end());
  for (std::size_t n = 0; n < rows.size(); ++n) rows[n].standard = Knobs().*table[n].member;
  return rows;
}

/// `rows` are rows_of(table), and outlive the values.
template <class Knobs>
knob_values values_of(const std::vector<knob_of<Knobs>>& table, const std::vector<knob_row>& rows,
                      const Knobs& k) {
  std::vector<int> values;
  values.reserve(table.size());
  for (const auto& row : table) values.push_back(k.*row.member);
  return {rows, std::move(values)};
}

/// Throws std::logic_error if they are another engine's.
void expect_rows(const knob_values& values, const std::vector<knob_row>& rows);

/// Back into the struct. Throws as expect_rows() does.
template <class Knobs>
void put_values(const std::vector<knob_of<Knobs>>& table, const std::vector<knob_row>& rows,
                const knob_values& values, Knobs& to) {
  expect_rows(values, rows);
  for (std::size_t n = 0; n < table.size(); ++n) to.*table[n].member = values[n];
}

}  // namespace racebeam
