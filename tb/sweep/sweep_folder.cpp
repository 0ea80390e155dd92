// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_folder.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <system_error>
#include <thread>
#include <vector>

#include "tb/base/leftovers.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/store_errors.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

// What a run that was killed early may leave without a store.
constexpr const char* Own[] = {"sweep.toml",
                               "sweep.sqlite",
                               "sweep.sqlite-wal",
                               "sweep.sqlite-shm",
                               "sweep.sqlite-journal",
                               "lock",
                               "status.json",
                               "figures.csv",
                               "pictures",
                               "failed",
                               "plan",
                               "results",
                               "log"};
constexpr std::size_t LongestName = 100;

/// Who has the lock, as the lock's file says: "8f3a01c2-4711 1795349000".
struct Owner {
  explicit Owner(const std::string& text) {
    char mark[9] = "";
    long long since = 0;
    known = std::sscanf(text.c_str(), "%8[0-9a-f]-%d %lld", mark, &process, &since) == 3;
    here = known && owner_mark().compare(0, 8, mark) == 0;
    begun = static_cast<std::time_t>(since);
  }
  /// It may be the mark of one that has ended.
  bool gone() const { return !known || (here && kill(process, 0) != 0 && errno == ESRCH); }

  std::string words() const {
    std::tm then{}, now{};
    const std::time_t time = std::time(nullptr);
    localtime_r(&begun, &then);
    localtime_r(&time, &now);
    const bool today = then.tm_yday == now.tm_yday && then.tm_year == now.tm_year;
    return fmt::format("process {} on {} machine since {}", process, here ? "this" : "another",
                       today ? fmt::format("{:%H:%M}", then) : fmt::format("{:%F %H:%M}", then));
  }

  bool known = false, here = false;
  int process = 0;
  std::time_t begun = 0;
};

}  // namespace

SweepFolder::SweepFolder(const std::string& path, Access access) : path_(path), folder_(path) {
  if (access == Access::Read) {
    std::error_code ignored;
    if (!fs::exists(store(), ignored))
      throw UsageError(path_ + " is not the folder of a sweep: it has no sweep.sqlite");
    return;
  }
  const std::vector<std::string> made = make_folder(path);
  check();
  lock_.emplace(file("lock"));
  if (const int error = lock_->error()) {
    for (const std::string& level : made) fs::remove(level);
    throw OutputError(path_, error, "");
  }
  take();
}

// A folder of something else is left alone, the lock's file is not even made there.
void SweepFolder::check() const {
  std::error_code error;
  if (fs::exists(store(), error)) return;
  for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name[0] != '.' && std::find(std::begin(Own), std::end(Own), name) == std::end(Own))
      throw UsageError(path_ + " is not the folder of a sweep: it has " + name +
                       ", but no sweep.sqlite; name a new folder with -o");
  }
}

// Who was killed a moment ago may have children that still have the lock, and who has just taken it
// has not said so yet: both are over soon.
void SweepFolder::take() {
  constexpr int Tries = 100;
  constexpr std::chrono::milliseconds Pause(20);
  for (int i = 0; !lock_->take(); ++i) {
    const Owner owner(lock_->text());
    if (owner.gone() && i < Tries) {
      std::this_thread::sleep_for(Pause);
      continue;
    }
    throw UsageError(fmt::format("{} is in use by {}; racebeam sweep status {} shows how far it is",
                                 path_, owner.gone() ? "another process" : owner.words(), path_));
  }
  lock_->write(fmt::format("{} {}\n", owner_mark(), std::time(nullptr)));
}

std::optional<std::string> SweepFolder::user() const {
  if (lock_) return Owner(lock_->text()).words();
  std::error_code ignored;
  if (!fs::exists(file("lock"), ignored)) return {};
  FileLock lock(file("lock"));
  if (lock.error() || lock.take()) return {};
  return Owner(lock.text()).words();
}

std::string SweepFolder::sweep() const { return whole_file(file("sweep.toml")); }
std::string SweepFolder::status() const { return whole_file(file("status.json")); }

void SweepFolder::keep_sweep(const std::string& text) const {
  if (text != sweep()) keep("sweep.toml", text);
}

void SweepFolder::keep_status(const std::string& json) const { keep("status.json", json); }

void SweepFolder::keep_figures(const std::string& csv) const { keep("figures.csv", csv); }

std::string SweepFolder::keep_failure(const std::string& point, const std::string& text) const {
  const std::string name = "failed/" + file_name_of(point) + ".txt";
  keep(name, text, "failed");
  return name;
}

void SweepFolder::keep_picture(const std::string& name, const std::string& bytes) const {
  keep("pictures/" + name, bytes, "pictures");
}

bool SweepFolder::has_picture(const std::string& name) const {
  std::error_code ignored;
  return fs::exists(file("pictures/" + name), ignored);
}

void SweepFolder::keep(const std::string& name, const std::string& text,
                       const std::string& folder) const {
  try {
    if (!folder.empty()) make_folder(file(folder));
    write_text(file(name), text);
  } catch (const OutputError&) {
    std::error_code error;
    if (const auto space = fs::space(folder_, error); !error && space.available < text.size() + 1)
      throw DiskFull(path_);
    throw;
  }
}

std::string file_name_of(const std::string& name) {
  std::string text;
  for (const char c : name)
    text += std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' ||
                    (c == '.' && !text.empty())
                ? std::string(1, c)
                : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  if (text.size() <= LongestName) return text.empty() ? "%" : text;
  return text.substr(0, LongestName) + "-" + text_hash(name).substr(0, 8);
}

}  // namespace racebeam
