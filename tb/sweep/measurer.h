// Measurer: what a store has of a sweep's points, and workers that bring what it lacks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/sweep/block_place.h"
#include "tb/sweep/block_runner.h"
#include "tb/sweep/store.h"
#include "tb/sweep/sweep_folder.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

/// Frames that a point is to have.
struct Want {
  int point = 0, scene = 0;
  std::vector<int> frames;
  bool guard = false;
};

class Measurer : private BlockRunner::Owner {
 public:
  /// All of it outlives this. `look` is called ten times a second at least while workers run.
  /// With another place, that is where points are measured.
  Measurer(const SweepPlan& plan, const SweepFolder& folder, Store& store, std::int64_t model,
           ForkServer& server, int jobs, std::function<void()> look, BlockPlace* place = nullptr);

  /// The plan has got more points.
  void take_in_points();
  /// Frames of these that are not there.
  int missing(const std::vector<Want>& wants) const;
  /// Brings them, those of the base first. False: it was interrupted. Throws NotDeterministic,
  /// DiskFull and what Store throws.
  bool measure(const std::vector<Want>& wants);
  /// Does frames anew, whether they are there or not: they must be as they were.
  bool repeat(const Want& want);
  /// What shows the worst frames of the base, of all frames that may be taken.
  bool scan(int scene);
  /// Pictures of frames of a point, packed, by frame; nothing of it is stored.
  std::map<int, std::string> pictures(const Want& want);

  FrameKey key(int point, int scene) const;
  /// Why a point could not be measured; "": it was, so far.
  const std::string& failure(int point) const { return failures_[std::size_t(point)]; }
  /// A point that cannot be measured, for a reason that is known before.
  void refuse(int point, const std::string& reason);
  int failed() const;
  /// Forgets the failures of earlier runs of points that are measured now.
  void forget_failures();
  std::int64_t measured() const { return measured_; }  ///< frames by this

 private:
  void prepare(Block& block) override;
  void take(const Block& block, const std::vector<Answer>& answers) override;
  void fail(const Block& block, const std::string& reason, const std::string& words) override;
  void look() override { look_(); }

  std::vector<int> lacks(const Want& want) const;
  Block block_of(const Want& want) const;
  /// A block of frames of `want` from the `begin`th on, `size` at most; so many they are.
  std::size_t add_block(std::list<Block>& blocks, const Want& want, std::size_t begin,
                        std::size_t size);
  void add_blocks(std::list<Block>& blocks, const Want& want);
  bool measure_elsewhere(const std::vector<Want>& wants);
  bool run(std::list<Block> blocks);
  struct PictureKeys;
  PictureKeys picture_keys(const Block& block) const;
  struct Kept {
    std::vector<int> sample, guard, causes;  // frames, in order; those whose errors have causes
  };
  Kept& kept(int point, int scene) { return kept_[index(point, scene)]; }
  const Kept& kept(int point, int scene) const { return kept_[index(point, scene)]; }
  std::size_t index(int point, int scene) const;

  const SweepPlan& plan_;
  const SweepFolder& folder_;
  Store& store_;
  const std::int64_t model_;
  ForkServer& server_;
  const int jobs_;
  const std::function<void()> look_;
  BlockPlace* const place_;
  std::vector<std::int64_t> scenes_, points_;  // ids; points by scene
  std::vector<Kept> kept_;
  std::vector<std::string> failures_;
  std::map<int, std::string>* pictures_ = nullptr;
  int blocks_ = 0;
  std::int64_t measured_ = 0;
};

}  // namespace racebeam
