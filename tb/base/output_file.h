// OutputFile: a file that appears under its name only when it is whole.
//
// It is written beside its final place under a temporary name and renamed by commit(), so that a
// run that is killed, or a full disk, leaves no half file. What exists and is not a regular file
// (a device, a pipe) is written in place. As with `mv -f`, whoever may write to the folder may
// replace a file in it, a write-protected one too.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace racebeam {

/// A file cannot be written; what() is "cannot write PATH: REASON".
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& path, const std::string& reason);
  /// The reason is errno's text, or `otherwise` if `error` is 0.
  OutputError(const std::string& path, int error, const std::string& otherwise);
};

/// Whoever reads the standard output has gone, as `head` does: nothing to say, exit code 141.
class ClosedPipe : public OutputError {
  using OutputError::OutputError;
};

/// The extension of a file's name in lower case, ".png": whatever a path ends with, its case says
/// nothing.
std::string extension_of(const std::string& path);

class OutputFile {
 public:
  /// Writes nothing yet. Throws OutputError if the folder does not exist or `path` is a folder.
  explicit OutputFile(const std::string& path);
  /// Removes the temporary file unless commit() was called.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return path_; }
  /// Where to write meanwhile: same folder, same extension. For libraries that open files
  /// themselves; others use write().
  const std::string& temporary_path() const { return temporary_; }

  /// Appends `size` bytes. Throws OutputError, also on a full disk; Interrupted while nobody reads
  /// a pipe.
  void write(const void* data, std::size_t size);

  /// Ends the writing. Throws OutputError if something could not be written, nothing was written,
  /// or the file is shorter than `at_least` bytes.
  void finish(std::uintmax_t at_least = 0);
  /// Gives the file its name, after finish(). Throws OutputError.
  void commit(std::uintmax_t at_least = 0);

 private:
  void remove_temporary();

  std::string path_;       // as given, for messages
  std::string final_;      // links resolved
  std::string temporary_;  // equals final_ if written in place
  std::FILE* stream_ = nullptr;
  bool committed_ = false;
};

/// Writes a whole text file. Throws OutputError.
void write_text(const std::string& path, std::string_view text);

/// Makes a folder and those above it. Returns the new ones, innermost first; none is left if it
/// throws OutputError.
std::vector<std::string> make_folder(const std::string& folder);

/// Whether files can be written to a folder, which may not be there yet. Leaves nothing. Throws
/// OutputError.
void try_folder(const std::string& folder);

}  // namespace racebeam
