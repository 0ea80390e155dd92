// The user's cache: files that can be made again, named by what they are made of.
//
// RACEBEAM_CACHE, else racebeam in XDG_CACHE_HOME or ~/.cache, else a folder of the user's own
// among the temporary ones. What was not used for longest goes when there is too much.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace racebeam {

/// The folder, which exists. Throws UsageError if it cannot be written, with the reason.
const std::string& cache_folder();

/// A name that says what `parts` are: 32 hexadecimal digits.
std::string content_key(const std::vector<std::string>& parts);
/// What a file holds, as such a name; empty if it cannot be read.
std::string file_key(const std::string& path);

/// The path of the file `name` of the cache, which counts as used now; empty if it is not there.
std::string in_cache(const std::string& name);
/// Moves a file of a WorkFolder into the cache, and gives its path there. Throws RtlError.
std::string put_in_cache(const std::string& file, const std::string& name);

/// The path of the file `name` of the cache; `make` writes it, at the path that it is given, if it
/// is not there. The file appears whole or not at all; of several processes one makes it, while the
/// others wait. Throws what `make` throws, RtlError, Interrupted.
std::string cached(const std::string& name, const std::function<void(const std::string&)>& make);

/// An empty folder in the cache, which goes with the object, or, after a crash, when another is
/// made.
class WorkFolder {
 public:
  /// Throws RtlError with the reason.
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// Writes a file of it. Throws RtlError.
  void write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
  int lock_;
};

}  // namespace racebeam
