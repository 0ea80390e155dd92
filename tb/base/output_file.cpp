// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/leftovers.h"

namespace racebeam {

namespace fs = std::filesystem;

OutputError::OutputError(const std::string& path, const std::string& reason)
    : std::runtime_error("cannot write " + path + ": " + reason) {}

OutputError::OutputError(const std::string& path, int error, const std::string& otherwise)
    : OutputError(path, error ? std::string(std::strerror(error)) : otherwise) {}

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

namespace {

/// A pipe without a reader is waited for, but not for ever: the user may want to stop.
std::FILE* open_file(const std::string& path) {
  std::error_code error;
  if (!fs::is_fifo(path, error)) return std::fopen(path.c_str(), "wb");
  constexpr int Pause = 20'000;  // microseconds
  for (;;) {
    const int file = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (file >= 0) {
      fcntl(file, F_SETFL, O_WRONLY);
      return fdopen(file, "wb");
    }
    if (errno != ENXIO) return nullptr;
    if (interrupted()) throw Interrupted();
    usleep(Pause);
  }
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path) {
  static std::atomic<int> serial{0};
  std::error_code error;
  fs::path target(path);
  if (path.empty()) throw OutputError("\"\"", ENOENT, "");
  if (fs::is_symlink(target, error)) {
    const fs::path real = fs::canonical(target, error);
    if (!error) target = real;
  }
  final_ = target.string();
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status) || !target.has_filename()) throw OutputError(path, EISDIR, "");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    temporary_ = final_;
    return;
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw OutputError(path, fs::exists(folder, error) ? ENOTDIR : ENOENT, "");
  }
  remove_leftovers(folder.string());
  const std::string name = "." + target.stem().string() + "." + owner_mark() + "-" +
                           std::to_string(++serial) + target.extension().string();
  temporary_ = (target.has_parent_path() ? folder / name : fs::path(name)).string();
}

OutputFile::~OutputFile() {
  if (stream_) std::fclose(stream_);
  if (!committed_) remove_temporary();
}

void OutputFile::remove_temporary() {
  std::error_code error;
  if (temporary_ != final_) fs::remove(temporary_, error);
}

void OutputFile::write(const void* data, std::size_t size) {
  errno = 0;
  if (!stream_) stream_ = open_file(temporary_);
  if (!stream_) throw OutputError(path_, errno, "cannot open");
  if (size > 0 && std::fwrite(data, 1, size, stream_) != size)
    throw OutputError(path_, errno, "short write");
}

void OutputFile::finish(std::uintmax_t at_least) {
  if (stream_) {
    errno = 0;
    const bool whole = !std::ferror(stream_);
    const bool good = std::fclose(stream_) == 0 && whole;
    const int error = errno;
    stream_ = nullptr;
    if (!good) throw OutputError(path_, error, "short write");
  }
  if (temporary_ != final_) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(temporary_, error);
    if (error) throw OutputError(path_, error.value(), "nothing was written");
    if (size < at_least) throw OutputError(path_, "the file is short; is the disk full?");
  }
}

void OutputFile::commit(std::uintmax_t at_least) {
  finish(at_least);
  if (temporary_ != final_ && std::rename(temporary_.c_str(), final_.c_str()) != 0)
    throw OutputError(path_, errno, "cannot rename");
  committed_ = true;
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit(text.size());
}

std::vector<std::string> make_folder(const std::string& folder) {
  std::error_code error, ignored;
  std::vector<std::string> made;
  for (fs::path level = fs::absolute(folder).lexically_normal();
       !level.empty() && !fs::exists(level, ignored); level = level.parent_path())
    if (level.has_filename()) made.push_back(level.string());
  fs::create_directories(folder, error);
  if (error && !fs::is_directory(folder, ignored)) {
    for (const std::string& level : made) fs::remove(level, ignored);
    throw OutputError(folder, error.value(), "");
  }
  return made;
}

void try_folder(const std::string& folder) {
  const std::vector<std::string> made = make_folder(folder);
  const bool writable = access(folder.c_str(), W_OK) == 0;
  const int error = errno;
  std::error_code ignored;
  for (const std::string& level : made) fs::remove(level, ignored);
  if (!writable) throw OutputError(folder, error, "");
}

}  // namespace racebeam
