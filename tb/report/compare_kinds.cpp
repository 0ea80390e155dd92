// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/compare_kinds.h"

#include <stdexcept>
#include <string>

#include "sc/base/constants.h"
#include "sc/beam/engine.h"
#include "sc/block/block_rays.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/bench/benches.h"
#include "tb/host/block_program.h"
#include "tb/judge/goldens.h"

namespace racebeam {

namespace {

void add_busy_lines(const Show& show, const knob_values&, const ChipBench::Frame& frame,
                    Spread& costs) {
  const auto& lines = show.engine().lines;
  for (std::size_t n = 0; n < lines.size(); ++n)
    if (lines[n].name == std::string("busy_clocks"))
      for (const int clocks : frame.stats->lines[n]) costs.add(clocks);
}

void add_pixels(const Show& show, const knob_values& k, const ChipBench::Frame& frame,
                Spread& costs) {
  const engine& built = show.engine();
  const PixelClocks pixels =
      bench_of(built).pixels({built, k, show.tables(), show.frames()}, frame.number);
  for (std::size_t n = 1; n < pixels.begins.size(); ++n)
    costs.add(static_cast<int>(pixels.begins[n] - pixels.begins[n - 1]));
}

/// Of the core that draws a pixel, in a job that waits for nobody; what a job takes before its
/// first pixel belongs to that. A cleared block's clocks are shared by its pixels.
void add_jobs(const Show& show, const knob_values& values, const ChipBench::Frame& frame,
              Spread& costs) {
  const block_knobs k = values;
  block_rays rays(k, converted(tables_of(block_program_of(show.tables()), k, frame.number), k));
  for (int y = 0; y < k.rows(); y += BlockSide)
    for (int x = 0; x < k.columns(); x += BlockSide) {
      const block_job& job = rays.job(x, y);
      const auto pixels = static_cast<int>(job.begins.size());
      for (int n = 0, from = 0; n < pixels; ++n) {
        const int to = job.cleared      ? job.clocks * (n + 1) / pixels
                       : n + 1 < pixels ? job.begins[static_cast<std::size_t>(n) + 1]
                                        : job.clocks;
        costs.add(to - from);
        from = to;
      }
    }
}

}  // namespace

const std::vector<CompareKind>& compare_kinds() {
  static const std::vector<CompareKind> table = {{beam_engine(), add_busy_lines, VisibleColumns},
                                                 {sphere_engine(), add_pixels, 1},
                                                 {block_engine(), add_jobs, 1},
                                                 {voxel_engine(), add_pixels, 1}};
  return table;
}

const CompareKind& compare_kind_of(const engine& built) {
  for (const CompareKind& kind : compare_kinds())
    if (&kind.engine == &built) return kind;
  throw std::out_of_range(std::string("no comparison of ") + built.name);
}

std::optional<VgaFrame> ideal_picture(const Show& show, const knob_values& k, int picture) {
  if (const GoldenKind* const golden = golden_of(show.engine()))
    return golden->picture(show.tables(), k, picture);
  if (!show.of_rooms()) return {};
  VgaFrame frame;
  frame.colours = golden_picture(GoldenTracer::Geometry, show.golden_world(picture, k),
                                 show.golden_camera(picture, k));
  return frame;
}

}  // namespace racebeam
