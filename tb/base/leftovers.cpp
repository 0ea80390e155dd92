// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/leftovers.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>
#include <system_error>

#include "tb/base/text_pattern.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// Process numbers mean something on one machine, and there in one name space of processes.
const std::string& machine() {
  static const std::string mark = [] {
    char name[256] = "";
    gethostname(name, sizeof name - 1);
    std::error_code error;
    const std::string space = fs::read_symlink("/proc/self/ns/pid", error).string();
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x",
                  static_cast<unsigned>(std::hash<std::string>{}(name + space)));
    return std::string(digits);
  }();
  return mark;
}

}  // namespace

std::string owner_mark() { return machine() + "-" + std::to_string(getpid()); }

void remove_leftovers(const std::string& folder) {
  static std::set<std::string> seen;
  if (!seen.insert(folder).second) return;
  const TextPattern name("\\..*\\." + machine() + "-([0-9]{1,9})-[0-9]+(\\..*)?");
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string file = at->path().filename().string();
    if (file[0] != '.') continue;
    const TextPattern::Groups owner = name.match(file);
    if (owner.empty()) continue;
    if (!at->is_regular_file(error)) continue;
    if (kill(std::atoi(owner[1].c_str()), 0) == 0 || errno != ESRCH) continue;
    std::error_code ignored;
    fs::remove(at->path(), ignored);
  }
}

}  // namespace racebeam
