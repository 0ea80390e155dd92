// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/waits.h"

#include <fmt/format.h>

#include <stdexcept>

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/bench/beam_waits.h"
#include "tb/bench/picture_waits.h"

namespace racebeam {

namespace {

bool always(const knob_values&) { return true; }

/// With one clock a pixel the FIFO, which cannot both shrink and listen, takes nothing once the
/// beam starves.
bool takes_time_to_listen(const knob_values& k) { return k.of("clocks_per_pixel") > 1; }

}  // namespace

const WaitKind& waits_of(const engine& built) {
  // Lines of a raster of 525.
  static const std::vector<WaitKind> table = {
      {beam_engine(),
       {"ack", "lock"},
       "an interval was taken",
       100,
       {"line_done", "lock"},
       50,
       2,
       {},
       takes_time_to_listen,
       make_beam_waits},
      {sphere_engine(),
       {"word_valid", "table_write", "take_valid"},
       "a word was offered",
       525,
       {},
       0,
       20,
       {"loaded", "picture_done", "rst_n"},
       always,
       make_sphere_waits},
      {block_engine(),
       {"bus_valid", "write", "take_valid"},
       "a word was offered",
       525,
       {},
       0,
       20,
       {},
       always,
       make_block_waits},
      {voxel_engine(),
       {"put_valid", "occupancy_write", "take_valid"},
       "a word was offered",
       525,
       {},
       0,
       20,
       {"start", "ray_done", "leaf", "leaf_done"},
       always,
       make_voxel_waits},
  };
  for (const WaitKind& kind : table)
    if (&kind.engine == &built) return kind;
  throw std::out_of_range(std::string("no waits of ") + built.name);
}

std::string text_of(const std::vector<Wait>& chain) {
  std::string text;
  for (const Wait& wait : chain) {
    text += text.empty() ? "" : ";\n";
    text += wait.unit + (wait.port.empty() ? " waits for nobody" : " waits for " + wait.port);
    if (wait.clocks > 0) text += fmt::format(", for {} clocks", wait.clocks);
    if (!wait.what.empty()) text += ": " + wait.what;
  }
  return text;
}

}  // namespace racebeam
