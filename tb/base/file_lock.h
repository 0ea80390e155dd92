// FileLock: one process at a time.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// A lock on a file or a folder, free when the process that took it has ended, however it ends, and
/// the children that it forked since. A file system without locks has none: then it can be taken.
class FileLock {
 public:
  /// Makes the file if there is nothing of this name.
  explicit FileLock(const std::string& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// errno, if it cannot be opened; then it can be taken, too.
  int error() const { return error_; }
  /// False if another process has it.
  bool take();

  /// What the file says, such as who has the lock.
  std::string text() const;
  /// Says that, if it can.
  void write(const std::string& text);

 private:
  int file_;
  int error_;
};

}  // namespace racebeam
