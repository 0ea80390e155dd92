// What tests of racebeam sweep begin with: a small sweep, and what its store holds in the end.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/program.h"
#include "tests/cli/racebeam_processes.h"

namespace racebeam {

/// Four points of the demo, 16 frames each.
inline constexpr const char* SmallSweep =
    "name = \"small\"\n"
    "[frames]\nsample = 16\nguard = 0\n"
    "[knobs]\ninterval_stack_depth = [2, 4]\nhurry_threshold = [32, 64]\n"
    "[measure]\nsilicon = \"off\"\n";

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
    Program run(folder.path(), run_words(out, more));
    EXPECT_EQ(run.wait(), 0) << run.err();
  }
  /// All frames of a sweep as CSV.
  std::string frames_of(const std::string& out) const {
    Program run(folder.path(), {"sweep", "export", out, "--frames", out + ".csv"});
    EXPECT_EQ(run.wait(), 0) << run.err();
    return read_file(folder / (out + ".csv"));
  }

  ScratchFolder folder;
};

/// The cells of a CSV file by the names in its head; none is in quotes.
inline std::vector<std::map<std::string, std::string>> read_csv(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> head;
  std::vector<std::map<std::string, std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (head.empty()) {
      head = row;
      continue;
    }
    row.resize(head.size());
    rows.emplace_back();
    for (std::size_t i = 0; i < head.size(); ++i) rows.back()[head[i]] = row[i];
  }
  return rows;
}

}  // namespace racebeam
