// VcdWriter: a value change dump (IEEE 1364-2005, 18.2), kept in memory or written as it grows.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/base/output_file.h"

namespace racebeam {

/// Times in picoseconds. Signals are added before the first change.
class VcdWriter {
 public:
  /// A name under which a signal is found.
  struct Name {
    std::string scope, name;
    int signal;
    std::string path() const { return scope + "." + name; }
  };

  /// A signal of 1..64 bits in a scope such as "chip.u_stacks"; returns its number.
  int add(const std::string& scope, const std::string& name, int bits);
  /// A signal whose values are words without blanks: GTKWave's extension "string".
  int add_text(const std::string& scope, const std::string& name);
  /// One more name of a signal, for the other end of a wire.
  void alias(const std::string& scope, const std::string& name, int signal);

  /// The signal has this value from `time` on; nothing is written if it had it already. Times
  /// never fall.
  void change(std::uint64_t time, int signal, std::uint64_t value) {
    Signal& s = signals_[static_cast<std::size_t>(signal)];
    if (!s.known || s.value != value) write(time, s, value);
  }
  /// The same of a signal of add_text(); blanks and control characters become `_`.
  void change(std::uint64_t time, int signal, const std::string& word);

  /// The file, up to `end`. `comment` says where it comes from; `$` and control characters become
  /// `_` in it.
  std::string text(const std::string& comment, std::uint64_t end) const;

  /// From now on changes go to `file`, which must outlive them, instead of memory.
  void stream(OutputFile& file, const std::string& comment);
  /// The end of a streamed file, which is then to be committed. Throws OutputError, as changes do.
  void finish(std::uint64_t end);

  /// Written so far.
  std::uint64_t bytes() const { return written_ + changes_.size(); }
  const std::vector<Name>& names() const { return names_; }
  /// Signals, however many names they have.
  std::size_t signals() const { return signals_.size(); }
  /// Of a signal; 0: words.
  int bits(int signal) const { return signals_.at(static_cast<std::size_t>(signal)).bits; }

 private:
  struct Signal {
    int bits;
    std::string ending;  ///< of a line with a change: the identifier code
    bool known = false;
    std::uint64_t value = 0;
    std::string word{};
  };

  int add_signal(const std::string& scope, const std::string& name, int bits);
  void write(std::uint64_t time, Signal& signal, std::uint64_t value);
  void step(std::uint64_t time);
  void flush();
  std::string header(const std::string& comment) const;
  std::string ending(std::uint64_t end) const;

  std::vector<Signal> signals_;
  std::vector<Name> names_;
  std::string changes_;
  std::uint64_t time_ = 0;
  bool started_ = false;
  bool dumping_ = false;  // the values of the first time are a section of their own
  OutputFile* file_ = nullptr;
  std::string comment_;
  std::uint64_t written_ = 0;  // bytes in the file
  bool headed_ = false;        // the header is in the file
};

}  // namespace racebeam
