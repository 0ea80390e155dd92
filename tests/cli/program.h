// Runs the program racebeam as a user does and keeps what it says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <csignal>
#include <string>
#include <vector>

#include "tests/support/json.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {

std::string read_file(const std::string& path);

/// A file of JSON. Throws std::exception if it is none.
Json read_json(const std::string& path);

/// One run of the program in a folder. Ends with the object.
class Program {
 public:
  struct Setting {
    std::string stdout_path = {};         ///< instead of a file for out()
    rlim_t largest_file = RLIM_INFINITY;  ///< bytes: a full disk
    bool terminal = false;                ///< stderr is one
    std::string environment = {};         ///< one more NAME=VALUE
    bool group = false;                   ///< leads a process group, as on a terminal
    std::string program = RACEBEAM_BINARY;
  };

  Program(const std::string& folder, const std::vector<std::string>& arguments)
      : Program(folder, arguments, Setting()) {}
  Program(const std::string& folder, const std::vector<std::string>& arguments,
          const Setting& setting);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;
  /// To all of its process group: Ctrl-C on a terminal. With Setting::group.
  void signal_group(int number) const;
  int id() const { return pid_; }
  /// It has not ended, or nobody has waited for it.
  bool runs() const;
  /// Processes that it has started and that live.
  int children() const { return static_cast<int>(children_ids().size()); }
  std::vector<int> children_ids() const;
  /// What it has said on stderr so far.
  std::string said() const { return read_file(said_ / "err"); }

  /// Waits for the end. The exit code, or -signal if it was killed.
  int wait();
  /// Until its terminal has shown `text`, or it has ended.
  void wait_for(const std::string& text);
  std::string out();
  std::string err();
  Json json() { return Json::parse(out()); }

 private:
  [[noreturn]] void become(const std::string& folder, const std::vector<std::string>& arguments,
                           const Setting& setting, int screen);
  bool read_terminal();

  ScratchFolder said_;
  const std::string out_path_;
  int terminal_ = -1;
  std::string screen_;
  pid_t pid_ = -1;
  int code_ = 0;
};

}  // namespace racebeam
