// Windows of a waveform, and their comparison with the cores.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/cli/traced_chip.h"
#include "tests/cli/wave.h"

namespace racebeam {

/// Both ends are in it.
struct Window {
  FrameClock from, to;

  std::vector<std::string> arguments() const { return {"--from", from.text(), "--to", to.text()}; }
};

/// The clock with this ordinal.
FrameClock place_at(std::int64_t ordinal, int line_clocks);

/// Random numbers whose first ones differ from seed to seed.
std::minstd_rand random_from(int seed);

int below(std::minstd_rand& random, int count);

/// Up to two lines, from any clock to any other. `over_the_end`: of a frame.
Window random_window(std::minstd_rand& random, int frames, int line_clocks, bool over_the_end);

/// Compares registers and wires of `wave`, the whole window, with the cores in every clock. `chip`
/// stands in the first clock of the window's frame. Units in `rtl_beside` run in lockstep: the
/// registers of their RTL are compared as well.
void expect_the_cores(const Wave& wave, const Window& window, TracedChip& chip,
                      const std::vector<std::string>& rtl_beside = {});

/// Compares each port of a unit, "chip.u_stacks.tag_i", with the wire, or the pin of the chip, that
/// it is bound to: that of its name. Returns how many there are.
int expect_ports_are_wires(const Wave& wave);

/// Compares what lies under `scope`, the RTL's side of a lockstep, with what the model has at the
/// same path. Returns how many there are on both sides.
int expect_both_sides(const Wave& wave, const std::string& scope);

}  // namespace racebeam
