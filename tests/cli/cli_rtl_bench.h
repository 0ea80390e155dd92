// RTL of users through the command line: the stacks with changes, and a cache of a test alone.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "tb/base/project_folder.h"
#include "tb/twin/beam_twins.h"
#include "tb/verilate/cache_folder.h"
#include "tests/cli/program.h"

namespace racebeam {

namespace fs = std::filesystem;

inline const std::vector<std::string> Short = {"--frames", "0", "--random", "2000"};

class CliRtlTest : public testing::Test {
 protected:
  static std::vector<std::string> verify(const std::string& word,
                                         const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"verify", word};
    words.insert(words.end(), Short.begin(), Short.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  }
  /// The unit's own text with one place changed.
  static std::string changed(const std::string& unit, const std::string& from,
                             const std::string& to) {
    std::string text = read_file(rtl_file(unit));
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
  void expect(int code, const std::vector<std::string>& words, const std::string& said = "") {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), code) << run.err();
    EXPECT_THAT(run.err(), testing::HasSubstr(said));
  }
  /// A cache of this test alone, with Verilator's run time and nothing of RTL.
  Program::Setting own_cache() const {
    add_run_time(cache());
    Program::Setting setting;
    setting.environment = "RACEBEAM_CACHE=" + cache();
    return setting;
  }
  static void add_run_time(const fs::path& cache) {
    beam_plugins({}).own("stacks");  // which makes it
    fs::create_directories(cache);
    for (const auto& entry : fs::directory_iterator(cache_folder())) {
      const fs::path name = entry.path().filename();
      if (name.string().rfind("verilator-", 0) == 0 && !fs::exists(cache / name))
        fs::create_symlink(entry.path(), cache / name);
    }
  }
  std::string cache() const { return folder / "cache"; }
  /// Waits for it, a minute at most.
  static bool becomes_true(const std::function<bool()>& condition) {
    for (int n = 0; n < 6000 && !condition(); ++n) usleep(10'000);
    return condition();
  }
  int in_cache(const std::string& extension) const {
    int found = 0;
    for (const auto& entry : fs::directory_iterator(cache()))
      found += entry.path().extension() == extension &&
               entry.path().filename().string().rfind("lock", 0) != 0;
    return found;
  }
  /// The stacks with a constant 1 that comes from elsewhere.
  static std::string stacks_with(const std::string& one) {
    return changed("stacks", "(n + 1) % IntervalStackDepth",
                   "(n + " + one + ") % IntervalStackDepth");
  }

  ScratchFolder folder;
};

}  // namespace racebeam
