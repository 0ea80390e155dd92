// OutputFolder: the folder of a render. One run at a time writes to it, and all runs that do have
// the same settings: its manifest tells the truth of every frame in it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tb/base/file_lock.h"
#include "tb/report/manifest.h"

namespace racebeam {

class OutputFolder {
 public:
  /// Makes the folder and takes it for this process and its children, until they end. `what` has
  /// the settings. Throws OutputError; UsageError if another run writes to it, or, unless
  /// `overwrite`, if it has frames of other settings.
  OutputFolder(const std::string& path, const Manifest& what, bool overwrite);
  /// Removes what the constructor made unless start() was called.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// To be called when nothing is in the way of writing: removes the frames of an earlier render
  /// that is overwritten, and writes the settings, so that a run that is killed leaves them too.
  /// Throws OutputError.
  void start();

  /// Path of a file in the folder.
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// How the manifest names a file anywhere: seen from the folder.
  std::string name_of(const std::string& path) const;

  /// Writes the manifest of this run and the ones before it. Throws OutputError.
  void write(Manifest manifest) const;
  /// There are no frames: removes the manifest that start() wrote.
  void abandon() const;

  /// Whether the folder itself needs a file of this name.
  static bool owns(const std::string& name);

 private:
  void check(const Manifest& what) const;

  const std::filesystem::path path_;
  const Manifest what_;
  const bool overwrite_;
  std::vector<std::string> made_;  // innermost first
  std::string before_;             // manifest of earlier runs that stays; or empty
  FileLock lock_;
  bool started_ = false;
};

}  // namespace racebeam
