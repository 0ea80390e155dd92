// What a store says of points beside their frames, and of the runs that measured them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/sweep/database.h"
#include "tb/sweep/frame_table.h"

namespace racebeam {

/// A point that could not be measured.
struct Failure {
  FrameKey key;
  std::string reason;
  int tries = 0;
};

class FailureTable {
 public:
  explicit FailureTable(Database& database) : database_(database) {}
  /// It has failed once more.
  void put(const FrameKey& key, const std::string& reason);
  /// It has been measured after all.
  void remove(const FrameKey& key);
  std::vector<Failure> all(std::int64_t model) const;

 private:
  Database& database_;
};

/// A point that racing left behind.
struct StoppedPoint {
  std::int64_t point = 0;
  int frames = 0;       ///< that it was measured with
  std::int64_t by = 0;  ///< the point that dominates it
  std::string why;
};

class StoppedTable {
 public:
  explicit StoppedTable(Database& database) : database_(database) {}
  /// All that are stopped, in the place of those before; one transaction.
  void replace(std::int64_t model, const std::vector<StoppedPoint>& points);
  std::vector<StoppedPoint> all(std::int64_t model) const;

 private:
  Database& database_;
};

/// A number of each frame of a scene that shows which are the worst.
struct ScannedFrame {
  int frame = 0;
  std::int64_t busy_max = 0, starved = 0;
};

/// All frames of a base point: its worst ones are the guard frames of all points.
class ScanTable {
 public:
  explicit ScanTable(Database& database) : database_(database) {}
  /// One transaction; those that are there stay.
  void put(const FrameKey& key, const std::vector<ScannedFrame>& frames);
  std::vector<ScannedFrame> read(const FrameKey& key) const;

 private:
  Database& database_;
};

/// What a sweep wants to know again, by name.
class NoteTable {
 public:
  explicit NoteTable(Database& database) : database_(database) {}
  /// "": there is none.
  std::string find(const std::string& name) const;
  void put(const std::string& name, const std::string& text);

 private:
  Database& database_;
};

struct SweepRun {
  std::string host, cpu;
  int cores = 0;
  std::string command, tools;
  // When it is read:
  std::int64_t id = 0;
  std::string started{}, ended{};  ///< "2026-11-22T12:03:00Z"; "": it was killed, or goes on
  double cpu_seconds = 0;
};

class RunTable {
 public:
  explicit RunTable(Database& database) : database_(database) {}
  /// Its id, to end it.
  std::int64_t begin(const SweepRun& run);
  void end(std::int64_t id, double cpu_seconds);
  std::vector<SweepRun> all() const;

 private:
  Database& database_;
};

}  // namespace racebeam
