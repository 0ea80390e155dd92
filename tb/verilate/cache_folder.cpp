// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/cache_folder.h"

#define XXH_INLINE_ALL
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/file_lock.h"
#include "tb/base/interrupt.h"
#include "tb/base/whole_file.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t MostBytes = 1'000'000'000;
constexpr std::uintmax_t SmallBytes = 4096;  // such as a proof: minutes of work
constexpr std::chrono::hours SmallStays{24 * 30};
constexpr int Locks = 64;  // each is for many files, so that their number has a bound

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Makes the folder, for its owner only; the reason if that fails or nothing can be written there.
std::string make_writable(const fs::path& folder) {
  std::error_code error;
  const bool there = fs::exists(folder, error);
  fs::create_directories(folder, error);
  if (error) return error.message();
  if (!there) fs::permissions(folder, fs::perms::owner_all, error);
  return access(folder.c_str(), W_OK | X_OK) == 0 ? "" : std::strerror(errno);
}

/// A folder that others could have made, or write to, is not to be trusted with code.
bool is_own(const fs::path& folder) {
  struct stat facts {};
  return lstat(folder.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode) &&
         facts.st_uid == geteuid() && (facts.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

std::string find_folder() {
  if (const std::string named = variable("RACEBEAM_CACHE"); !named.empty()) {
    const std::string why = make_writable(named);
    if (why.empty()) return fs::absolute(named);
    throw UsageError("the cache " + named + " of RACEBEAM_CACHE cannot be written: " + why);
  }
  const std::string caches = variable("XDG_CACHE_HOME"), home = variable("HOME");
  const fs::path users = !caches.empty() ? fs::path(caches) / "racebeam"
                         : !home.empty() ? fs::path(home) / ".cache/racebeam"
                                         : fs::path();
  if (!users.empty() && make_writable(users).empty()) return fs::absolute(users);
  const std::string named = variable("TMPDIR");
  const fs::path temporaries = fs::absolute(named.empty() ? "/tmp" : named);
  const fs::path temporary = temporaries / ("racebeam-" + std::to_string(geteuid()));
  std::error_code error;
  const std::string why = fs::is_directory(temporaries, error) ? make_writable(temporary)
                          : error                              ? error.message()
                                                               : "no such folder";
  if (!why.empty())
    throw UsageError("there is no place for the cache: " + temporary.string() + ": " + why +
                     "; set TMPDIR or RACEBEAM_CACHE to a folder that can be written");
  if (!is_own(temporary))
    throw UsageError(temporary.string() +
                     " belongs to somebody else; set RACEBEAM_CACHE to a folder of yours");
  return temporary;
}

/// Takes a lock of the cache, however long that takes.
void wait_for(FileLock& lock) {
  if (lock.error())
    throw RtlError("cannot write to " + cache_folder() + ": " + std::strerror(lock.error()));
  catch_interrupts();
  while (!lock.take()) {
    if (interrupted()) throw Interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
}

/// Locks of plug-ins are others than those of the objects that are made for them.
std::string lock_of(const std::string& name) {
  const auto n = std::hash<std::string>{}(name) % Locks;
  return cache_folder() + "/lock." + std::to_string(n) + fs::path(name).extension().string();
}

bool is_work(const fs::path& path) { return path.filename().string().rfind("work.", 0) == 0; }
bool is_lock(const fs::path& path) { return path.filename().string().rfind("lock.", 0) == 0; }

/// Removes work folders whose process is dead.
void remove_left() {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(cache_folder(), ignored)) {
    if (!is_work(entry.path())) continue;
    const int folder = open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) continue;
    if (flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry.path(), ignored);
    close(folder);
  }
}

/// Removes what was not used for longest, down to four fifths of what is allowed. Small files,
/// which take little place, are not for a month longer.
void trim() {
  struct Entry {
    fs::file_time_type until;
    std::uintmax_t bytes;
    fs::path path;
  };
  std::vector<Entry> entries;
  std::uintmax_t bytes = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(cache_folder(), ignored)) {
    if (!entry.is_regular_file(ignored) || is_lock(entry.path())) continue;
    const std::uintmax_t size = entry.file_size(ignored);
    const auto stays = size <= SmallBytes ? SmallStays : SmallStays.zero();
    entries.push_back({entry.last_write_time(ignored) + stays, size, entry.path()});
    bytes += size;
  }
  if (bytes <= MostBytes) return;
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.until < b.until; });
  for (const Entry& entry : entries) {
    if (bytes <= MostBytes / 5 * 4) return;
    if (fs::remove(entry.path, ignored)) bytes -= entry.bytes;
  }
}

std::string hexadecimal(XXH128_hash_t hash) {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, hash);
  std::string text;
  for (const unsigned char byte : bytes.digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

}  // namespace

const std::string& cache_folder() {
  static const std::string folder = find_folder();
  return folder;
}

std::string content_key(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += std::to_string(part.size()) + ":" + part;
  return hexadecimal(XXH3_128bits(text.data(), text.size()));
}

std::string file_key(const std::string& path) {
  return std::ifstream(path) ? content_key({whole_file(path)}) : "";
}

std::string in_cache(const std::string& name) {
  const std::string path = cache_folder() + "/" + name;
  std::error_code error;
  fs::last_write_time(path, fs::file_time_type::clock::now(), error);
  return error ? "" : path;
}

std::string put_in_cache(const std::string& file, const std::string& name) {
  const std::string path = cache_folder() + "/" + name;
  std::error_code error;
  fs::rename(file, path, error);
  if (error) throw RtlError("cannot write " + path + ": " + error.message());
  trim();
  return path;
}

std::string cached(const std::string& name, const std::function<void(const std::string&)>& make) {
  if (const std::string path = in_cache(name); !path.empty()) return path;
  FileLock lock(lock_of(name));
  wait_for(lock);
  if (const std::string path = in_cache(name); !path.empty()) return path;
  const WorkFolder work;
  make(work.file(name));
  return put_in_cache(work.file(name), name);
}

WorkFolder::WorkFolder() {
  FileLock lock(cache_folder() + "/lock.work");  // a new folder is not taken for a left one
  wait_for(lock);
  remove_left();
  path_ = cache_folder() + "/work.XXXXXX";
  if (!mkdtemp(path_.data()))
    throw RtlError("cannot write " + cache_folder() + ": " + std::strerror(errno));
  lock_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  flock(lock_, LOCK_EX | LOCK_NB);
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  close(lock_);
}

void WorkFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream out(file(name));
  out << text;
  out.close();
  if (!out) throw RtlError("cannot write " + file(name) + "; is the disk full?");
}

}  // namespace racebeam
