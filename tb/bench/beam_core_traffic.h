// The traffic of a unit of the beam's chip over consecutive frames, made by the cores: the same as
// record_chip_traffic() hears in the wired chip, some ten times as fast.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sc/beam/chip_core.h"
#include "sc/beam/chip_wires.h"
#include "tb/twin/traffic_file.h"

namespace racebeam {

class BeamCoreTraffic : public TrafficSource {
 public:
  /// `program`: nullptr for the built-in demo; outlives it.
  BeamCoreTraffic(TrafficHead head, const knobs& k, const scene_program* program, int first,
                  int frames);

  const TrafficHead& head() const override { return head_; }
  bool next(TrafficBlock& block) override;
  void rewind() override;
  std::vector<TrafficMark> marks() const override;
  std::uint64_t clocks() const override { return clocks_; }

 private:
  void seek(TrafficBlock& block);
  std::size_t port(const char* name) const;
  void clock(bool rst_n, std::uint64_t* row);

  const TrafficHead head_;
  const knobs knobs_;
  const scene_program* const program_;
  const int first_, frames_;
  const std::uint64_t clocks_;
  chip_core core_;
  chip_wires wires_{};
  std::vector<std::pair<const int*, std::uint64_t>> ports_;  // wire, and bits that count
  std::vector<std::uint64_t> last_;                          // the last clock
  std::uint64_t done_ = 0;
  bool sought_ = false;
};

}  // namespace racebeam
