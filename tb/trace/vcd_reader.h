// VcdReader: a value change dump from a file, one moment after the other.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace racebeam {

class VcdReader {
 public:
  /// Reads the header. Throws UsageError: no such file, or no VCD.
  explicit VcdReader(const std::string& path);
  /// The same of a dump that lies elsewhere; `name` is what errors call it.
  VcdReader(std::unique_ptr<std::istream> in, const std::string& name);

  /// Signals by path, "chip.u_stacks.tag_i"; several paths may be one signal.
  const std::map<std::string, int>& signals() const { return signals_; }
  /// All paths in the order of the file.
  const std::vector<std::string>& paths() const { return paths_; }
  int bits(int signal) const { return bits_[static_cast<std::size_t>(signal)]; }
  /// Digits without leading zeros, or a word; empty until the first change.
  const std::string& value(int signal) const { return values_[static_cast<std::size_t>(signal)]; }

  /// The time of the changes that follow; none at the end of the file.
  std::optional<std::uint64_t> next_time() const { return next_; }
  /// Takes the changes of next_time(); the numbers of the signals. Throws UsageError if the file is
  /// broken.
  const std::vector<int>& advance();

 private:
  void read_header();
  void read_variable(const std::vector<std::string>& scopes);
  void take(const std::string& word);
  [[noreturn]] void broken(const std::string& what) const;

  const std::string path_;
  const std::unique_ptr<std::istream> in_;
  std::map<std::string, int> signals_;
  std::vector<std::string> paths_;
  std::unordered_map<std::string, int> codes_;
  std::vector<int> bits_;
  std::vector<std::string> values_;
  std::vector<int> changed_;
  std::optional<std::uint64_t> next_;
};

}  // namespace racebeam
