// A virtual platform for tlm_sphere.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "sc/sphere/tlm_sphere.h"
#include "tests/support/picture_platform.h"

namespace racebeam {

/// A picture of 320 x 240, two clocks a word.
struct SpherePlatform : testing::Test {
  static constexpr int Narrow = 0;

  SpherePlatform() {
    chip.display_socket.bind(display.socket);
    host.socket.bind(chip.host_socket);
    registers.socket.bind(chip.register_socket);
  }
  /// To `clocks` clocks after the reset, in the middle of a clock.
  void run_to(std::int64_t clocks) {
    const sc_core::sc_time end = (static_cast<double>(clocks) + 1.5) * Clock;
    sc_core::sc_start(end - sc_core::sc_time_stamp());
  }

  const sc_core::sc_time Clock{clock_period_ps(1), sc_core::SC_PS};
  sphere_tables tables;
  sphere_board board{Narrow, 15};
  tlm_sphere chip{"chip", {}, tables, board};
  PictureDisplay display{"display", VisibleColumns, VisibleRows};
  WordInitiator host{"host"}, registers{"registers"};
};

}  // namespace racebeam
