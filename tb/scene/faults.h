// Faults: what is wrong in a scene file, all of it, each with its place and what to do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tb/scene/place.h"

namespace racebeam {

struct Fault {
  Place place;       ///< line 0: the file as a whole
  std::string what;  ///< "rooms 'a' and 'b' overlap"
  std::string help;  ///< what to do
};

class Faults {
 public:
  static constexpr int Kept = 1000;  ///< more are only counted

  void add(Place place, std::string what, std::string help);
  /// What is allowed, but is probably not what the author meant.
  void warn(Place place, std::string what, std::string help);
  bool none() const { return count_ == 0; }
  /// All that were met; kept() holds the first ones.
  int count() const { return count_; }
  const std::vector<Fault>& kept() const { return kept_; }
  /// By line and column: "FILE:LINE:COLUMN: what" and "  help: ...", each on a line of its own.
  std::string text(const std::string& file) const;
  /// The same of the warnings: "FILE:LINE:COLUMN: warning: what".
  std::string warnings(const std::string& file) const;

 private:
  std::vector<Fault> kept_, warnings_;
  int count_ = 0;
};

/// 'text' in quotes, shortened, with nothing in it that a terminal would act on.
std::string quoted(std::string_view text);

}  // namespace racebeam
