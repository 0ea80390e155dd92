// The keys of a scene file, each documented once: what the reader accepts and docs/scenes.md lists.
// Other TOML files have tables of the same kind.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace racebeam {

struct FileKey {
  const char* table;     ///< "" for the top of the file
  const char* key;       ///< in that table
  const char* type;      ///< with its range
  const char* standard;  ///< what holds without it
  const char* meaning;
};

/// All of them, in the order of the page.
const std::vector<FileKey>& scene_keys();
/// The keys of one table.
std::vector<std::string> keys_of(std::string_view table,
                                 const std::vector<FileKey>& keys = scene_keys());
/// One line of the page's table, without the newline.
std::string key_row(const FileKey& key);

}  // namespace racebeam
