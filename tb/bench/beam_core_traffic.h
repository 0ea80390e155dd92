// The traffic of units of the beam's chip over consecutive frames, made by the cores in one pass
// for all of them: the same as record_chip_traffic() hears in the wired chip, some ten times as
// fast.
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

/// The cores of the chip, and what the ports of units have.
class BeamCorePass {
 public:
  /// A head for each unit, the whole chip too; `program`: nullptr for the built-in demo; outlives
  /// it.
  BeamCorePass(std::vector<TrafficHead> heads, const knobs& k, const scene_program* program,
               int first, int frames);

  const std::vector<TrafficHead>& heads() const { return heads_; }
  /// The next block of each unit; one may be empty. False: there is none.
  bool next(std::vector<TrafficBlock>& blocks);
  void rewind();
  std::vector<TrafficMark> marks() const;
  std::uint64_t clocks() const { return clocks_; }

 private:
  /// Where the ports of a unit are.
  struct Unit {
    std::vector<std::pair<const int*, std::uint64_t>> ports;  // wire, and bits that count
    std::vector<std::uint64_t> last;                          // in reset
  };
  void seek(std::size_t unit, TrafficBlock& block);
  std::size_t port(std::size_t unit, const char* name) const;

  const std::vector<TrafficHead> heads_;
  const knobs knobs_;
  const scene_program* const program_;
  const int first_, frames_;
  const std::uint64_t clocks_;
  chip_core core_;
  chip_wires wires_{};
  std::vector<Unit> units_;
  std::uint64_t done_ = 0;
  bool sought_ = false;
};

/// That of one unit.
class BeamCoreTraffic : public TrafficSource {
 public:
  /// As of BeamCorePass.
  BeamCoreTraffic(const TrafficHead& head, const knobs& k, const scene_program* program, int first,
                  int frames)
      : pass_({head}, k, program, first, frames) {}

  const TrafficHead& head() const override { return pass_.heads().front(); }
  bool next(TrafficBlock& block) override;
  void rewind() override { pass_.rewind(); }
  std::vector<TrafficMark> marks() const override { return pass_.marks(); }
  std::uint64_t clocks() const override { return pass_.clocks(); }

 private:
  BeamCorePass pass_;
  std::vector<TrafficBlock> blocks_;
};

}  // namespace racebeam
