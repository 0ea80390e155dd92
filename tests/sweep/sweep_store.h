// What tests of a sweep's store begin with: a store with a model, a scene and a point, and frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "tb/sweep/row_digest.h"
#include "tb/sweep/store.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {

/// From now on temporary files are kept in memory, where that can be.
struct MemoryFirst {
  MemoryFirst() {
    if (access("/dev/shm", W_OK) == 0) setenv("TMPDIR", "/dev/shm", 0);
  }
};

/// Where to wait for no disk: what a process leaves that is killed is the same there.
struct QuickFolder : MemoryFirst, ScratchFolder {};

inline const std::vector<std::string> Columns = {"decisions", "busy_clocks.max", PictureColumn};

/// A frame with three values that follow from one.
inline MeasuredFrame measured(int frame, std::int64_t value, bool guard = false) {
  MeasuredFrame result;
  result.row = {frame, guard, 0, {value, value % 1600, picture_digest(std::to_string(value))}};
  result.row.digest = frame_digest(frame, result.row.values);
  return result;
}

struct OpenStore : Store {
  explicit OpenStore(const std::string& file, Access access = Access::Write)
      : OpenStore(file, access, Journal::Log) {}
  OpenStore(const std::string& file, Access access, Journal journal)
      : Store(file, access, journal) {
    if (access == Access::Read) return;
    key.model = model({"3f9c", "0.2.0", "abc", "program", "g++"}, Columns);
    key.scene = scene({"demo", "d3", 12799});
    key.point = points({{"dr_bits=10\nfifo_entries=10\n", "chip"}}).front();
  }

  FrameKey key{1, 1, 1};
};

inline void PrintTo(Journal journal, std::ostream* out) {
  *out << (journal == Journal::Log ? "Log" : "Rollback");
}

inline bool operator==(const FrameRow& a, const FrameRow& b) {
  return a.frame == b.frame && a.guard == b.guard && a.digest == b.digest && a.values == b.values;
}

/// What an error says; "no error" if there is none.
template <class Work>
std::string error_of(const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace racebeam
