// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/output_file.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <regex>
#include <system_error>

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

// The process in a name such as ".a.123-4.gif", and the name without it, "a.gif"; 0 in others.
int process_of(const std::string& name, std::string& of) {
  static const std::regex form(R"(\.(.+)\.([0-9]{1,9})-[0-9]+(\.[^.]*)?)");
  std::smatch parts;
  if (!std::regex_match(name, parts, form)) return 0;
  of = parts[1].str() + parts[3].str();
  return std::stoi(parts[2]);
}

// Removes what OutputFiles for `target` have left in processes that were killed. A folder is looked
// through once: what comes later is of processes that live.
void remove_leftovers(const fs::path& folder, const fs::path& target) {
  static std::map<fs::path, std::multimap<std::string, fs::path>> all;
  std::error_code error;
  const auto [at, is_new] = all.try_emplace(fs::absolute(folder, error));
  std::string of;
  if (is_new)
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const int process = process_of(entry.path().filename().string(), of);
      if (process > 0 && kill(process, 0) != 0 && errno == ESRCH)
        at->second.emplace(of, entry.path());
    }
  const auto [first, end] = at->second.equal_range(target.filename().string());
  for (auto left = first; left != end; ++left) fs::remove(left->second, error);
  at->second.erase(first, end);
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
  remove_leftovers(folder, target);
  const std::string name = "." + target.stem().string() + "." + std::to_string(getpid()) + "-" +
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
  if (!stream_) stream_ = std::fopen(temporary_.c_str(), "wb");
  if (!stream_) throw OutputError(path_, errno, "cannot open");
  if (std::fwrite(data, 1, size, stream_) != size) throw OutputError(path_, errno, "short write");
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

}  // namespace racebeam
