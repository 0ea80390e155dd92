// FrameTable: the measured frames of a store, with what was counted beside them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tb/sweep/database.h"
#include "tb/sweep/frame_row.h"
#include "tb/sweep/histogram.h"

namespace racebeam {

/// Whose frames: ids of the store.
struct FrameKey {
  std::int64_t model = 0, scene = 0, point = 0;
};

/// A frame as a worker has measured it.
struct MeasuredFrame {
  FrameRow row;
  std::map<std::string, std::vector<std::int64_t>> histograms;
  std::map<std::string, std::int64_t> causes;  ///< pixels, if errors were asked for by cause
};

/// That a frame is there.
struct KeptFrame {
  int frame = 0;
  bool guard = false;
};
inline bool operator==(const KeptFrame& a, const KeptFrame& b) {
  return a.frame == b.frame && a.guard == b.guard;
}

/// All of it throws what Database throws.
class FrameTable {
 public:
  explicit FrameTable(Database& database) : database_(database) {}

  /// Stores a block, all or nothing; the number of frames that are new. A frame that is there must
  /// have the same digest, and is not written again; a guard frame becomes one of the sample if it
  /// comes as that, and its histograms then count. Causes are added to a frame that has none.
  /// Throws NotDeterministic if a frame is another one than before: the first result stays, both
  /// are kept as disputed, and so are the other frames of the block; std::invalid_argument of rows
  /// that do not fit the model's columns or their digest.
  int put(const FrameKey& key, const std::vector<MeasuredFrame>& block) {
    return put(key, block, {});
  }
  /// All that another store has of a point, if there is nothing of it here; the number of frames.
  /// Throws UsageError if it has other columns.
  int take_over(const FrameKey& key, const FrameTable& other, const FrameKey& from);

  /// Which frames are there, in order, by point.
  std::unordered_map<std::int64_t, std::vector<KeptFrame>> there(std::int64_t model,
                                                                 std::int64_t scene) const;
  /// The frames of a point, in order, with all columns of the model or these. Throws
  /// std::invalid_argument of other names.
  std::vector<FrameRow> read(const FrameKey& key, const std::vector<std::string>& columns) const;
  std::vector<FrameRow> read(const FrameKey& key) const { return read(key, columns(key.model)); }
  /// Of the sample, by name.
  std::map<std::string, Histogram> histograms(const FrameKey& key) const;
  /// Pixels by cause, by frame: of those that have them.
  std::map<int, std::map<std::string, std::int64_t>> causes(const FrameKey& key) const;
  /// The same as rows, with these causes as columns; one that a frame does not have is 0.
  std::vector<FrameRow> read_causes(const FrameKey& key,
                                    const std::vector<std::string>& causes) const;
  /// Which frames have causes, in order, by point.
  std::unordered_map<std::int64_t, std::vector<int>> with_causes(std::int64_t model,
                                                                 std::int64_t scene) const;
  /// All frames of a model.
  std::int64_t count(std::int64_t model) const;
  /// Frames that have differed from themselves.
  std::int64_t disputed(std::int64_t model) const;

  /// The columns of a model's frames. Throws std::invalid_argument if there is no such model.
  const std::vector<std::string>& columns(std::int64_t model) const;

 private:
  struct Block;
  int put(const FrameKey& key, const std::vector<MeasuredFrame>& block,
          const std::map<std::string, Histogram>& more);
  void put_row(Block& block, const FrameRow& row);
  void put_causes(Block& block, const MeasuredFrame& frame);
  void add_histograms(const Block& block);
  void dispute(Block& block, const FrameRow& row);

  Database& database_;
  mutable std::map<std::int64_t, std::vector<std::string>> columns_;
};

}  // namespace racebeam
