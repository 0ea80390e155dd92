// block_collector: counts a picture of the wired chip from its wires, as block_machine does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/block/counters.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// A core's wires in a clock, settled.
struct block_core_view {
  std::uint8_t state, event;
  bool waits;  // for the bus, with a word
};

struct block_view {
  bool sends;  // the host has a number, or waits for the last ones
  bool done;
  store_view store;
  std::array<block_core_view, BlockCores> cores;  // those that there are
};

class block_collector {
 public:
  explicit block_collector(const block_knobs& k)
      : cores_of_chip_(static_cast<std::size_t>(k.cores)),
        root_clocks_(k.root_clocks()),
        store_knobs_(k.store()) {}
  void observe(const block_view& v);
  /// While no picture is drawn: what was counted since the last one is forgotten.
  void begin() { now_ = {}; }
  /// Pictures that are done.
  int pictures() const { return pictures_; }
  /// The one that was done last.
  const block_counters& last() const { return last_; }

 private:
  struct core {
    int state = BlockIdle;  // of the clock before
    int pass = 0;           // passes that were shaded
    int near = 0;           // clocks in NEAR
    bool second = false;    // GROUP of a later pass: its second clock is next
    bool met = false;       // in the clock before a group was met, whole
  };
  void count_core(core& c, const block_core_view& v, std::uint64_t& busy);
  void count_state(core& c, int state);
  void count_event(int event);

  const std::size_t cores_of_chip_;
  const int root_clocks_;
  const store_knobs store_knobs_;
  std::array<core, BlockCores> cores_{};
  block_counters now_, last_;
  int pictures_ = 0;
  bool draws_ = false;  // in the clock before
  bool frame_begins_ = true;
};

}  // namespace racebeam
