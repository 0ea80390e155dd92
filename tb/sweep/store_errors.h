// What can happen to the store of a sweep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/base/errors.h"

namespace racebeam {

/// There is no room: what was being stored is not there, all before it is. Exit code 2.
class DiskFull : public UsageError {
 public:
  /// `kept`: what is there, such as "1,212 of 4,800 blocks are kept".
  explicit DiskFull(const std::string& folder,
                    const std::string& kept = "all that was stored is kept")
      : UsageError("the disk of " + folder + " is full; " + kept +
                   "; make room and run the same command again"),
        folder_(folder) {}

  /// The same of somebody who knows how much is kept.
  DiskFull keeping(const std::string& kept) const { return DiskFull(folder_, kept); }

 private:
  std::string folder_;
};

/// The store's file is not as SQLite left it. Exit code 2.
class DamagedStore : public UsageError {
 public:
  DamagedStore(const std::string& file, const std::string& folder, const std::string& what)
      : UsageError(file + " is damaged: " + what + "; racebeam sweep check " + folder +
                   " tells what can be read; nothing was overwritten") {}
};

/// A frame that was measured again is another one than before: the model is not what its hash says,
/// or not deterministic. Both results are kept, in the table disputed. Exit code 1.
class NotDeterministic : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace racebeam
