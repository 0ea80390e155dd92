// SweepFolder: where a sweep lives. Nothing in it is absolute: it can be moved.
//
//   sweep.toml       the sweep as it was read
//   sweep.sqlite     what was measured (store.h)
//   lock             who writes
//   status.json      how far it is
//   figures.csv      all figures of all points, once it is done
//   pictures/        of points
//   failed/          what points said that could not be measured
//   plan/            what a cluster is to do (rung_plan.h), results/ what its workers answered
//                    (block_results.h), log/ what they said
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tb/base/file_lock.h"
#include "tb/sweep/database.h"

namespace racebeam {

class SweepFolder {
 public:
  /// To write, makes the folder and takes it for this process, until it ends: children that it
  /// forks later keep it, too. Throws UsageError if it is not the folder of a sweep, or in use;
  /// OutputError if it cannot be written.
  SweepFolder(const std::string& path, Access access);

  /// As it was given.
  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string store() const { return file("sweep.sqlite"); }

  /// The sweep as it was read the last time; "": never.
  std::string sweep() const;
  /// All of these throw OutputError, or DiskFull.
  void keep_sweep(const std::string& text) const;
  /// Whole at any time.
  void keep_status(const std::string& json) const;
  void keep_figures(const std::string& csv) const;
  std::string status() const;
  /// The file's name, from the folder.
  std::string keep_failure(const std::string& point, const std::string& text) const;
  void keep_picture(const std::string& file, const std::string& bytes) const;
  bool has_picture(const std::string& file) const;

  /// "process 4711 on this machine since 12:03"; nothing if nobody writes to it.
  std::optional<std::string> user() const;

 private:
  void check() const;
  void take();
  void keep(const std::string& name, const std::string& text, const std::string& folder = "") const;

  const std::string path_;
  const std::filesystem::path folder_;
  std::optional<FileLock> lock_;
};

/// A name as that of a file: other characters than letters, digits, "._-" as "%" and two digits.
std::string file_name_of(const std::string& name);

}  // namespace racebeam
