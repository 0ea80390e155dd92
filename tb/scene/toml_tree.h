// TomlNode: a TOML file as a tree of plain values, each with its place.
//
// The only source file that includes toml++ is toml_tree.cpp.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tb/scene/faults.h"

namespace racebeam {

struct TomlEntry;

struct TomlNode {
  enum Kind { Table, Array, String, Integer, Float, Boolean, Date };

  Kind kind = Table;
  Place place{};
  std::string text{};                ///< of a String
  std::int64_t integer = 0;          ///< of an Integer; of a Boolean, 0 or 1
  double number = 0;                 ///< of a Float
  std::vector<TomlNode> items{};     ///< of an Array
  std::vector<TomlEntry> entries{};  ///< of a Table, in the order of the file

  /// "a string", "a table" ...
  const char* kind_name() const;
  /// The value of a key of a Table, or null.
  const TomlNode* find(std::string_view key) const;
};

struct TomlEntry {
  std::string key;
  Place place;  ///< of the key
  TomlNode value;
};

/// The tree, or nothing and a fault if the text is not TOML or is nested too deeply.
std::optional<TomlNode> parse_toml(std::string_view text, Faults& faults);

}  // namespace racebeam
