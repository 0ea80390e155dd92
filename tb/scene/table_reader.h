// TableReader: takes checked values out of one table of a scene file, or of another TOML file.
//
// Each read function leaves `to` alone and returns false if the key is missing or its value is a
// fault, which is added to the faults.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/scene/scene_file.h"
#include "tb/scene/scene_keys.h"
#include "tb/scene/toml_tree.h"

namespace racebeam {

class TableReader {
 public:
  /// `kind` names the table in `keys`; other keys are faults. So is a node that is no table.
  TableReader(const TomlNode& node, const std::string& kind, Faults& faults,
              const std::vector<FileKey>& keys = scene_keys());

  /// The value of a key, or null.
  const TomlNode* find(const std::string& key) const { return node_.find(key); }
  /// The same; a fault if it is missing.
  const TomlNode* require(const std::string& key, const std::string& help) const;

  /// `why` follows the range in the help.
  bool read(const std::string& key, int low, int high, int& to, const std::string& why = "") const;
  bool read(const std::string& key, bool& to) const;
  /// Not empty unless `may_be_empty`; at most 64 printable characters.
  bool read(const std::string& key, std::string& to, bool may_be_empty = false) const;
  /// Three whole numbers.
  bool read(const std::string& key, int low, int high, Vector& to) const;
  /// A number, with a point or without.
  bool read(const std::string& key, double low, double high, double& to) const;
  /// Three of them.
  bool read(const std::string& key, double low, double high, std::array<double, 3>& to) const;
  /// "#rrggbb" as 0xrrggbb.
  bool read_rgb(const std::string& key, std::uint32_t& to) const;
  /// The index of a word in `words`.
  bool read_choice(const std::string& key, const std::vector<std::string>& words, int& to) const;
  /// Four colours of three parts 0..3, as texts or as lists.
  bool read(const std::string& key, Palette& to) const;

  Place place() const { return node_.place; }
  Faults& faults() const { return faults_; }

 private:
  const TomlNode& node_;
  const std::string kind_;
  Faults& faults_;
};

/// Whole number within a range, or a fault. `name` is what the message calls it; `why` follows the
/// range in the help.
bool read_number(const TomlNode& node, const std::string& name, int low, int high, int& to,
                 Faults& faults, const std::string& why = "");
/// A number within a range, with a point or without, or a fault.
bool read_decimal(const TomlNode& node, const std::string& name, double low, double high,
                  double& to, Faults& faults);
/// The index of a word in `words`, or a fault.
bool read_word(const TomlNode& node, const std::string& name, const std::vector<std::string>& words,
               int& to, Faults& faults);
/// A short text, or a fault.
bool read_text(const TomlNode& node, const std::string& name, std::string& to, Faults& faults);
/// A fault: it is of another type than the one that is wanted.
void wrong_type(const TomlNode& node, const std::string& name, const std::string& wanted,
                Faults& faults);
/// "did you mean 'x'?" or the names that there are.
std::string name_help(const std::string& name, const std::vector<std::string>& known);

}  // namespace racebeam
