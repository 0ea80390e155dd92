// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/tracer_3.h"

#include <utility>

#include "tb/golden/trace_state.h"

namespace racebeam {

namespace {

TraceState trace_3(const TraceTree& tree, const vec3& dr, RayWork& work) {
  TraceState state;
  std::uint64_t here = 0;  // decisions in this room
  while (!state.wall_hit) {
    const bool is_decision = state.question != TraceState::Signs;
    state = tree.next(state, tree.question(state).answer(dr));
    ++work.clocks;
    work.decisions += is_decision;
    here += is_decision;
    if (!state.enters()) continue;
    ++work.clocks;
    ++work.rooms_entered;
    work.crossing_decisions += std::exchange(here, 0);
  }
  ++work.clocks;
  ++work.rays;
  work.solid_hits += state.is_solid();
  work.solid_decisions += state.is_solid() ? here : 0;
  return state;
}

}  // namespace

GoldenHits trace_3_line(const GoldenWorld& world, const GoldenRays& rays, int y, RayWork* work) {
  const TraceTree tree(world, world.offset_z(y));
  RayWork unseen;
  GoldenHits hits;
  for (int pixel = 0; pixel < VisibleColumns; ++pixel)
    hits[pixel] = trace_3(tree, rays[pixel], work ? *work : unseen).end().hit;
  return hits;
}

}  // namespace racebeam
