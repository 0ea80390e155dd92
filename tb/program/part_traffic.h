// The traffic of a part of a show, for several units in one pass.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "tb/program/replay_part.h"
#include "tb/program/verify_replay.h"

namespace racebeam {

/// A unit, and what traffic of it is of.
struct ReplayUnit {
  const Replay* what;
  const TrafficHead* head;
};

/// Who takes the traffic of a unit, by blocks.
class BlockSink : public TrafficSink {
 public:
  static constexpr std::size_t BlockClocks = 4096;  ///< they stay in the second cache

  explicit BlockSink(std::size_t ports) : ports_(ports) {}
  virtual void take(const TrafficBlock& block) = 0;

  void add(const std::uint64_t* row, bool is_private) override {
    if (is_private != block_.is_private || block_.values.size() == BlockClocks * ports_) flush();
    if (block_.values.empty()) {
      block_.first = clocks_;
      block_.is_private = is_private;
    }
    block_.values.insert(block_.values.end(), row, row + ports_);
    clocks_ += !is_private;
  }
  void mark(std::int64_t) override {}
  /// Takes what is left.
  void flush() {
    if (!block_.values.empty()) take(block_);
    block_.values.clear();
  }
  std::size_t ports() const { return ports_; }

 private:
  const std::size_t ports_;
  TrafficBlock block_;
  std::uint64_t clocks_ = 0;
};

/// Makes all of it; a sink for each unit. The cores of the beam's chip make it, or the wired chip
/// of another engine, once in a process. Throws Interrupted.
void make_traffic(const std::vector<ReplayUnit>& units, const ReplayPart& part,
                  const std::vector<BlockSink*>& sinks);

}  // namespace racebeam
