// What tests of racebeam sweep begin with: a small sweep, and what its store holds in the end.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include "tests/cli/program.h"
#include "tests/cli/racebeam_processes.h"

namespace racebeam {

/// Four points of the demo, 16 frames each.
inline constexpr const char* SmallSweep =
    "name = \"small\"\n"
    "[frames]\nsample = 16\nguard = 0\n"
    "[knobs]\ninterval_stack_depth = [2, 4]\nhurry_threshold = [32, 64]\n"
    "[measure]\nsilicon = \"off\"\n";

/// Two points of four frames: what a start costs, and little more.
inline constexpr const char* TinySweep =
    "name = \"tiny\"\n"
    "[frames]\nsample = 4\nguard = 0\n"
    "[knobs]\nfifo_entries = [4, 10]\n"
    "[measure]\nsilicon = \"off\"\n";

/// "40", "41": the first column of a query.
inline std::vector<std::string> query(const std::string& store, const std::string& sql) {
  std::vector<std::string> cells;
  const auto take = [](void* to, int, char** row, char**) {
    static_cast<std::vector<std::string>*>(to)->emplace_back(row[0] ? row[0] : "NULL");
    return 0;
  };
  sqlite3* handle = nullptr;
  char* error = nullptr;
  sqlite3_open(store.c_str(), &handle);
  sqlite3_busy_timeout(handle, 10'000);
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), take, &cells, &error), SQLITE_OK)
      << (error ? error : "");
  sqlite3_free(error);
  sqlite3_close(handle);
  return cells;
}

/// The processes that measure for a run: children of its children.
inline std::vector<int> workers_of(const Program& run) {
  std::vector<int> all;
  for (const int server : run.children_ids()) {
    const std::string name = std::to_string(server);
    std::istringstream workers(read_file("/proc/" + name + "/task/" + name + "/children"));
    all.insert(all.end(), std::istream_iterator<int>(workers), {});
  }
  return all;
}

class CliSweepTest : public testing::Test {
 protected:
  using Words = std::vector<std::string>;

  void write(const std::string& text, const std::string& name = "s.toml") const {
    std::ofstream(folder / name) << text;
  }
  /// sweep run s.toml -o DIR with these words more.
  static Words run_words(const std::string& out, const Words& more = {}) {
    Words words = {"sweep", "run", "s.toml", "-o", out, "--jobs", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void expect_run(const std::string& out, const Words& more = {}) const {
    expect(run_words(out, more), 0);
  }
  /// What a command says on both, when it has ended so.
  std::string expect(const Words& words, int code, const Program::Setting& setting = {}) const {
    Program run(folder.path(), words, setting);
    EXPECT_EQ(run.wait(), code) << words[1] << ": " << run.err();
    return run.err() + run.out();
  }
  /// Runs the small sweep, and does this to each worker of its first point beside the base, again
  /// and again, until that has failed. What is said.
  std::string run_with_harm(const std::function<void(int process)>& harm) const {
    write(SmallSweep);
    Program run(folder.path(), {"sweep", "run", "s.toml", "-o", "out", "--jobs", "1"});
    const auto count = [this](const std::string& table) {
      const bool is_there =
          std::filesystem::exists(store("out")) &&
          !query(store("out"), "SELECT 1 FROM sqlite_schema WHERE name = '" + table + "'").empty();
      return is_there ? std::stoi(query(store("out"), "SELECT count(*) FROM " + table)[0]) : 0;
    };
    while (run.runs() && count("frame") < 16) usleep(1000);
    while (run.runs() && count("failure") == 0) {
      const std::vector<int> workers = workers_of(run);
      if (!workers.empty() && count("failure") == 0) harm(workers.front());
      usleep(1000);
    }
    EXPECT_EQ(run.wait(), 1) << run.err();
    EXPECT_EQ(query(store("out"), "SELECT count(*) FROM failure")[0], "1");
    EXPECT_EQ(
        query(store("out"), "SELECT point FROM frame GROUP BY point HAVING count(*) = 16").size(),
        3u)
        << "all others are complete";
    return run.err() + run.out();
  }
  std::string run_with_signals(int number) const {
    return run_with_harm([number](int worker) { kill(worker, number); });
  }
  std::string store(const std::string& out) const { return folder / (out + "/sweep.sqlite"); }
  /// All frames of a sweep as CSV.
  std::string frames_of(const std::string& out) const {
    Program run(folder.path(), {"sweep", "export", out, "--frames", out + ".csv"});
    EXPECT_EQ(run.wait(), 0) << run.err();
    return read_file(folder / (out + ".csv"));
  }

  ScratchFolder folder;
};

/// The cells of a CSV file by the names in its head.
inline std::vector<std::map<std::string, std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> all = {{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = all.back().back();
    if (text[i] == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') cell += text[i++];
    else if (text[i] == '"') quoted = !quoted;
    else if (quoted || (text[i] != ',' && text[i] != '\n')) cell += text[i];
    else if (text[i] == ',') all.back().emplace_back();
    else if (i + 1 < text.size()) all.push_back({""});
  }
  std::vector<std::map<std::string, std::string>> rows(all.size() - 1);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    all[row + 1].resize(all[0].size());
    for (std::size_t i = 0; i < all[0].size(); ++i) rows[row][all[0][i]] = all[row + 1][i];
  }
  return rows;
}

}  // namespace racebeam
