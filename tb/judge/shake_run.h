// ShakeRun: pictures of the wired chip with and without stalls, which must be the same, whatever
// its units are made of. No model is needed.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sc/base/stall_plan.h"
#include "tb/bench/wired_bench.h"
#include "tb/show/run.h"

namespace racebeam {

/// A picture with stalls beside the same without.
struct ShakenPicture {
  std::uint64_t seed = 0;
  int number = 0;                       ///< of the frame or picture
  std::uint64_t stalled = 0;            ///< clocks with a stall, of all channels
  std::uint64_t pixels = 0;             ///< whose colours differ
  int x = 0, y = 0;                     ///< the first of them
  std::uint32_t expected = 0, got = 0;  ///< its colour without stalls, and with them
  std::uint64_t starved = 0;            ///< pixels shown too soon, and intervals given up for that
};

class ShakeRun {
 public:
  /// One chip, so one in a process. Throws RtlError.
  ShakeRun(const Run& run, std::shared_ptr<const stall_plan> plan);
  ~ShakeRun();

  /// Why a picture cannot be judged: its colours are a function of time without stalls too. Shows
  /// it without stalls, if it has not been shown so; empty: it can be judged.
  std::string objection(int number);
  /// A picture with objection() empty. Throws RtlFault, Interrupted.
  ShakenPicture shake(std::uint64_t seed, int number);
  std::uint64_t clocks() const;

 private:
  struct Shown;
  struct Parts;
  Shown show(int number);
  const Shown& quiet(int number);

  std::unique_ptr<Parts> parts_;
};

}  // namespace racebeam
