// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/tracer_4.h"

#include <algorithm>
#include <vector>

#include "tb/golden/trace_state.h"

namespace racebeam {

namespace {

/// An interval that waits: its left end follows from what is traced before it.
struct Waiting {
  TraceState state;
  int last;
};

constexpr int NoLimit = LastPixel + 1;

class LineTracer {
 public:
  LineTracer(const GoldenWorld& world, const GoldenRays& rays, int y)
      : tree_(world, world.offset_z(y)), rays_(rays), bisection_(world.bisection) {}

  /// The whole line, with a stack of so many entries. Looks at each question for switches, if
  /// `counted`.
  void trace(int entries, IntervalWork* counted = nullptr) {
    Waiting now{{}, LastPixel};
    for (int first = 0;;) {
      descend(now, first, entries, counted);
      std::fill(ends.begin() + first, ends.begin() + now.last + 1, now.state.end());
      ++work.intervals;
      first = now.last + 1;
      if (first > LastPixel) return;
      return_to_waiting(now);
    }
  }

  std::array<GoldenEnd, VisibleColumns> ends;
  TraceWork work;

 private:
  /// From now.state down to a wall. The right part of what is cut off waits, and asks anew.
  void descend(Waiting& now, int first, int entries, IntervalWork* counted) {
    bool asked_before = first > 0;
    while (!now.state.wall_hit) {
      ++work.questions;
      const TraceQuestion question = tree_.question(now.state);
      const int left = question.answer(rays_[first]);
      const auto same_as_left = [&](int pixel) { return question.answer(rays_[pixel]) == left; };
      if (counted && !asked_before) count_switches(*counted, first, now.last, same_as_left);
      asked_before = false;
      if (!same_as_left(now.last)) {
        if (static_cast<int>(stack_.size()) == entries) stack_.erase(stack_.begin());
        stack_.push_back(now);
        now.last = golden_switch(first, now.last, bisection_, [&](int pixel) {
          ++work.probes;
          return same_as_left(pixel);
        });
      }
      now.state = tree_.next(now.state, left);
    }
  }

  template <class Question>
  static void count_switches(IntervalWork& counted, int first, int last,
                             const Question& same_as_left) {
    std::size_t switches = 0;
    bool same = true;
    for (int pixel = first + 1; pixel <= last; ++pixel)
      if (same_as_left(pixel) != same) same = !same, ++switches;
    counted.edges += switches > 0;
    counted.chattering_edges += switches > 1;
    ++counted.switches[std::min(switches, counted.switches.size() - 1)];
  }

  /// To the interval that waits for the shortest time, or to the top of the tree.
  void return_to_waiting(Waiting& now) {
    now = Waiting{{}, LastPixel};
    if (stack_.empty()) return;
    now = stack_.back();
    stack_.pop_back();
  }

  const TraceTree tree_;
  const GoldenRays& rays_;
  const int bisection_;
  std::vector<Waiting> stack_;
};

}  // namespace

GoldenHits trace_4_line(const GoldenWorld& world, const GoldenRays& rays, int y,
                        IntervalWork* work) {
  LineTracer tracer(world, rays, y);
  tracer.trace(NoLimit, work);
  if (work) {
    work->questions += tracer.work.questions;
    work->probes += tracer.work.probes;
    work->intervals += tracer.work.intervals;
  }
  GoldenHits hits;
  std::transform(tracer.ends.begin(), tracer.ends.end(), hits.begin(),
                 [](const GoldenEnd& e) { return e.hit; });
  return hits;
}

std::array<GoldenEnd, VisibleColumns> trace_4_ends(const GoldenWorld& world, const GoldenRays& rays,
                                                   int y) {
  LineTracer tracer(world, rays, y);
  tracer.trace(NoLimit);
  return tracer.ends;
}

TraceWork trace_4_work(const GoldenWorld& world, const GoldenRays& rays, int y, int entries) {
  LineTracer tracer(world, rays, y);
  tracer.trace(entries);
  return tracer.work;
}

}  // namespace racebeam
