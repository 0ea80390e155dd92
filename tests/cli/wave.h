// A value change dump as a test reads it: nothing of tb/ is used.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace racebeam {

/// Throws std::runtime_error where the file breaks the rules of IEEE 1364-2005, 18.2.
class Wave {
 public:
  struct Signal {
    int bits = 0;
    std::string kind;
    std::map<std::uint64_t, std::string> changes;

    /// Digits or word at `time`; empty before the first change.
    std::string at(std::uint64_t time) const;
    std::uint64_t number(std::uint64_t time) const;
    bool operator==(const Signal& other) const;
  };

  /// `ours`: the first values are to stand in $dumpvars.
  explicit Wave(const std::string& path, bool ours = true);

  const Signal& operator[](const std::string& path) const;

  /// Identifier of a signal in the file; the names of a wire share one.
  const std::string& code(const std::string& path) const { return codes_.at(path); }

  /// Signals, however many names they have.
  std::size_t codes() const { return by_code_.size(); }

  std::map<std::string, Signal> signals;  ///< by path
  std::uint64_t begin = 0, end = 0;       ///< first and last time
  std::string scale;

 private:
  // True at the end of the definitions.
  bool declare(const std::vector<std::string>& words, std::string& scope);
  void change(const std::vector<std::string>& words, std::uint64_t time);

  std::map<std::string, std::string> codes_;  // by path
  std::map<std::string, Signal> by_code_;
};

}  // namespace racebeam
