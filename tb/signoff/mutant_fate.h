// What became of a mutant, as a line of a file: a run that was killed goes on behind the last one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>

namespace racebeam {

struct MutantFate {
  /// Alive: not found by the streams, and not yet looked at further. Escaped: another stream, a
  /// counterexample, tells it from the unit.
  enum State { Alive, Found, Equal, Escaped, Undecided };

  int number = 0;
  State state = Alive;
  std::string stream;       ///< that found it; undecided: with what it was asked
  std::uint64_t clock = 0;  ///< of the stream; undecided: for how many seconds
  std::string port;         ///< empty: the mutant ended the RTL
  std::string note;         ///< why it is undecided; what an escaped one says
};

const char* word_of(MutantFate::State state);

std::string line_of(const MutantFate& fate);
/// Throws nlohmann::json::exception.
MutantFate fate_of(const std::string& line);

/// The fates in a file that begins with `key`: a file of another key, or none, is begun anew.
class FateFile {
 public:
  /// Throws OutputError.
  FateFile(const std::string& path, const std::string& key);
  const std::map<int, MutantFate>& fates() const { return fates_; }
  /// Adds or replaces one, also in the file. Throws OutputError.
  void add(const MutantFate& fate);

 private:
  const std::string path_;
  std::map<int, MutantFate> fates_;
  std::ofstream out_;
};

}  // namespace racebeam
