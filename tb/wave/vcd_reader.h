// VcdReader: a value change dump from a file, one moment after the other.
//
// It reads IEEE 1364-2005, 18.2, as we, Icarus, Verilator and fst2vcd write it, and GTKWave's
// words.
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

  /// What errors call it.
  const std::string& name() const { return name_; }
  /// One unit of its times, in femtoseconds; 1 ns if the file does not say.
  std::uint64_t unit() const { return unit_; }

  /// Signals by path, "chip.u_stacks.tag_i"; several paths may be one signal. The range of a whole
  /// vector is not in the path, but a bit or a part of one is: "q[3]", "q[7:4]". Where a file calls
  /// two signals the same, the second is "q'".
  const std::map<std::string, int>& signals() const { return signals_; }
  /// All paths in the order of the file.
  const std::vector<std::string>& paths() const { return paths_; }
  /// 0: words, which real numbers are too.
  int bits(int signal) const { return bits_[static_cast<std::size_t>(signal)]; }
  /// Digits 0 1 x z without those that the first one stands for, or a word; empty until the first
  /// change.
  const std::string& value(int signal) const { return values_[static_cast<std::size_t>(signal)]; }

  /// The time of the changes that follow; none at the end of the file. What a file says before its
  /// first time belongs to it.
  std::optional<std::uint64_t> next_time() const { return next_; }
  /// Takes the changes of next_time(); the numbers of the signals. Throws UsageError if the file is
  /// broken.
  const std::vector<int>& advance();

 private:
  void read_header();
  void read_unit();
  void read_variable(const std::vector<std::string>& scopes);
  void read_changes();
  void read_change(const std::string& word);
  std::uint64_t time_of(const std::string& word) const;
  std::vector<std::string> section();
  [[noreturn]] void broken(const std::string& what) const;

  const std::string name_;
  const std::unique_ptr<std::istream> in_;
  std::uint64_t unit_;
  std::map<std::string, int> signals_;
  std::vector<std::string> paths_;
  std::unordered_map<std::string, int> codes_;
  std::vector<int> bits_;
  std::vector<std::string> values_;
  std::vector<int> changed_, coming_;  // coming_: read, and not yet taken by advance()
  std::optional<std::uint64_t> next_;
};

}  // namespace racebeam
