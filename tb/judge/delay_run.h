// delays measured: pictures of the wired chip with registers in one channel, for each number of
// clocks, beside those without.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sc/base/delay_plan.h"
#include "tb/show/run.h"

namespace racebeam {

/// Some frames or pictures, in sum, with one channel delayed.
struct DelayedPictures {
  std::uint64_t clocks = 0;   ///< that the tracer was busy; of a picture, from start to end
  std::uint64_t starved = 0;  ///< pixels that the beam was before; 0 where nothing races it
  std::uint64_t pixels = 0;   ///< whose colours are not those without delays
};

/// A channel with 0, 1, ... clocks of latency.
struct ChannelSlack {
  std::string channel;
  std::vector<DelayedPictures> by_latency;

  /// The greatest latency up to which no pixel starves that does not without delays.
  int starving_slack() const;
  /// The greatest latency up to which no colour is another one.
  int colour_slack() const;
};

/// `channels` with latency 0 to `most`, an entry more than clocks, each in a process of its own,
/// `jobs` at once. `done` is told after each how many are. Throws what the runs throw, Interrupted.
std::vector<ChannelSlack> measure_slack(const Run& run, const std::vector<std::string>& channels,
                                        const std::vector<int>& numbers, int most, int jobs,
                                        const std::function<void(int)>& done);

}  // namespace racebeam
