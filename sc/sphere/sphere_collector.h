// sphere_collector: counts a picture of the wired chip from its wires, as sphere_core does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/sphere/counters.h"
#include "sc/sphere/knobs.h"

namespace racebeam {

/// The wires of a clock, settled.
struct sphere_view {
  int state;
  bool direct;  // not in a mirror
  std::int64_t sum;
  int shader_op;
  store_view store;
  bool fault, picture_done;
};

class sphere_collector {
 public:
  explicit sphere_collector(const sphere_knobs& k) : store_knobs_(k.resolved().store()) {}
  void observe(const sphere_view& v);
  /// In HOST: what was counted since the last picture is forgotten, but for faults.
  void begin() {
    const std::uint64_t faults = now_.host_faults;
    now_ = {};
    now_.host_faults = faults;
  }
  /// Pictures that are done.
  int pictures() const { return pictures_; }
  /// The one that was done last.
  const sphere_counters& last() const { return last_; }

 private:
  void count_state(const sphere_view& v);

  const store_knobs store_knobs_;
  sphere_counters now_, last_;
  int pictures_ = 0;
  int state_ = SphereHost;  // of the clock before
  bool frame_begins_ = true;
  std::uint64_t late_faults_ = 0;  // for the picture after this
};

}  // namespace racebeam
