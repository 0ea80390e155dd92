// What workers of a plan have answered: results/RUNG.BLOCK.N.jsonl, a file for each worker, which
// only appends. A line is an answer (block.h) with the hash of the plan before it. The last line
// may be torn: its worker was killed, or still writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "tb/sweep/block.h"
#include "tb/sweep/rung_plan.h"

namespace racebeam {

/// The file of a worker.
class ResultFile {
 public:
  /// A new one of this block: two workers never have the same. Throws OutputError.
  ResultFile(const std::string& folder, const RungPlan& plan, int block);
  ~ResultFile();
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  /// Lines of answer_line() or error_line(); they are on the disk then. Throws OutputError.
  void append(const std::string& lines);

 private:
  const std::string plan_;
  std::string path_;
  int file_ = -1;
};

/// Reads what is new in the files of a plan.
class ResultReader {
 public:
  /// Outlived by the plan. With a block: its files only.
  ResultReader(const std::string& folder, const RungPlan& plan, int block = -1);

  /// Of each line that is an answer to some of the work.
  using Take = std::function<void(int block, const PlannedWork& work, AnswerLine line)>;
  void read(const Take& take);

  /// What was not taken, a sentence for each file and reason; "": nothing.
  std::string refused() const;

 private:
  struct File {
    std::uintmax_t offset = 0;
    int block = 0;
    int of_others = 0, damaged = 0, not_asked = 0;  // lines
    std::string other{};                            // the hash of a line of others
  };
  void read(const std::string& name, File& file, const Take& take);
  void take_line(const std::string& line, File& file, const Take& take);

  const std::string folder_;
  const RungPlan& plan_;
  const int block_;
  std::map<std::string, File> files_;
};

}  // namespace racebeam
