// StreamPlayer: streams played on copies of a bench that itself stays at power-up.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tb/twin/shrink.h"
#include "tb/twin/twin_bench.h"

namespace racebeam {

class StreamPlayer {
 public:
  /// `twins` is at power-up, and nobody else runs it.
  explicit StreamPlayer(TwinBench& twins) : twins_(twins) {}

  /// The clocks of a stimulus as TwinBench::record() has them.
  PortStream record(Stimulus stimulus, unsigned seed, std::uint64_t clocks,
                    std::uint64_t most) const;
  /// The first difference from power-up on; nothing of RTL that ends the run, or after an
  /// interrupt.
  std::optional<StreamDifference> play(const PortStream& stream) const;
  /// A FindStream. Streams are played one after the other, each from its reset on, on one copy, as
  /// long as both sides agree; what fails there counts only if it fails from power-up on.
  std::optional<StreamHit> find(const std::string& port, std::size_t count,
                                const Streams& streams) const;
  /// `text` of the first difference from power-up on.
  std::string tell(const PortStream& stream,
                   const std::function<std::string(const LockstepDifference&)>& text) const;

 private:
  TwinBench& twins_;
};

}  // namespace racebeam
