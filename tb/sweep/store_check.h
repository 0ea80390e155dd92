// Whether a store is sound: what SQLite says of the file, and each stored result by its digest.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace racebeam {

struct StoreReport {
  std::vector<std::string> faults;           ///< sentences; none: it is sound
  std::map<std::string, std::int64_t> rows;  ///< that can be read, by table
};

/// Reads all of the file, and changes nothing. Throws UsageError if it is none of this version, or
/// not there.
StoreReport check_store(const std::string& file);

}  // namespace racebeam
