// Store: all that a sweep has measured, in one SQLite file with one writer.
//
// A result's key is what it depends on: the model, the scene, the point's setting and the frame.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/sweep/database.h"
#include "tb/sweep/frame_table.h"
#include "tb/sweep/schema.h"
#include "tb/sweep/store_caches.h"
#include "tb/sweep/store_notes.h"

namespace racebeam {

/// What counted: its key is `hash`, the rest is for people.
struct StoredModel {
  std::string hash, version, commit, program, compiler;
  std::int64_t id = 0;
};

struct StoredScene {
  std::string name, hash;
  std::int64_t frames = 0;
  std::int64_t id = 0;
};

/// Its key is the hash of `setting`: all that its results depend on beside model, scene and frame,
/// as sorted lines "name=value\n".
struct StoredPoint {
  std::string setting;
  std::string name;  ///< "": the sweep has no such point any more
  std::int64_t id = 0;
};

/// All of it throws what Database throws.
class Store {
 public:
  /// To write, makes the file if need be, and its folder must be there. Throws UsageError of a file
  /// of something else, of a newer version, or that is empty and only read.
  Store(const std::string& file, Access access);
  Store(const std::string& file, Access access, Journal journal);

  /// The model's id, in a store that has it or gets it: what counts into these columns. Throws
  /// UsageError if the same model had other columns.
  std::int64_t model(const StoredModel& model, const std::vector<std::string>& columns);
  std::int64_t scene(const StoredScene& scene);
  /// Their ids, in their order; one transaction. From now on no other point has a name. Points of
  /// scenes with other knobs may have the same one.
  std::vector<std::int64_t> points(const std::vector<StoredPoint>& points);

  /// What is there, in the order in which it came.
  std::vector<StoredModel> models();
  std::vector<StoredScene> scenes();
  std::vector<StoredPoint> points();

  Database& database() { return database_; }

 private:
  Database database_;

 public:
  FrameTable frames{database_};
  UnitCache units{database_};
  ChipCache chips{database_};
  ReferenceCache references{database_};
  FailureTable failures{database_};
  StoppedTable stopped{database_};
  ScanTable scans{database_};
  NoteTable notes{database_};
  RunTable runs{database_};
};

}  // namespace racebeam
