// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/tracer_4.h"

#include <algorithm>
#include <vector>

namespace racebeam {

namespace {

/// Questions of contract 11.2, in the order in which a room asks them. The first is asked once. The
/// next four are asked anew for each opening of a face until one is not missed.
enum Question { Signs, FarFirst, FarSecond, NearFirst, NearSecond, XOrY, Exit };

/// A node of the decision tree.
struct Node {
  int room = 0, depth = 0;  ///< the room may be one behind an opening that is under test
  int left = 0;             ///< the room that is left
  int opening = 0;          ///< of the face by which it is left
  Question question = Signs;
  int signs = 0;        ///< of the ray, bit a for axis a
  int face = 0;         ///< axis of the opening by which the room is entered
  bool y_wins = false;  ///< answer to XOrY
  bool wall = false;    ///< nothing to ask any more: a wall across `face` is hit
};

/// An interval that waits: its left end follows from what is traced before it.
struct Waiting {
  Node node;
  int last;
};

constexpr int NoLimit = LastPixel + 1;

class LineTracer {
 public:
  LineTracer(const GoldenWorld& world, const GoldenRays& rays, int y)
      : world_(world), rays_(rays), offset_z_(world.offset_z(y)) {}

  /// The whole line, with a stack of so many entries.
  void trace(int entries) {
    Waiting now{{}, LastPixel};
    for (int first = 0;;) {
      descend(now, first, entries);
      const GoldenHit hit{now.node.face, (now.node.signs >> now.node.face & 1) != 0};
      std::fill(ends.begin() + first, ends.begin() + now.last + 1,
                GoldenEnd{hit, now.node.left, now.node.depth - 1});
      ++work.intervals;
      first = now.last + 1;
      if (first > LastPixel) return;
      return_to_waiting(now);
    }
  }

  std::array<GoldenEnd, VisibleColumns> ends;
  TraceWork work;

 private:
  /// From now.node down to a wall. The right part of what is cut off waits.
  void descend(Waiting& now, int first, int entries) {
    while (!now.node.wall) {
      Node& node = now.node;
      ++work.questions;
      const int decision = decide(node, first);
      if (decide(node, now.last) != decision) {
        if (static_cast<int>(stack_.size()) == entries) stack_.erase(stack_.begin());
        stack_.push_back(now);
        now.last = golden_switch(first, now.last, world_.bisection, [&](int pixel) {
          ++work.probes;
          return decide(node, pixel) == decision;
        });
      }
      node = next(node, decision);
    }
  }

  /// To the interval that waits for the shortest time, or to the top of the tree.
  void return_to_waiting(Waiting& now) {
    now = Waiting{{}, LastPixel};
    if (stack_.empty()) return;
    now = stack_.back();
    stack_.pop_back();
  }

  /// The corner coordinate that the node's question is about.
  int corner(const Node& node, int axis) const {
    const GoldenRoom& room = world_.rooms[node.room];
    const int centre = room.position[axis] + (axis == 2 ? offset_z_ : 0);
    const bool in_far_question = node.question == FarFirst || node.question == FarSecond;
    const bool far = node.question >= XOrY || (in_far_question && axis != node.face);
    return world_.corner((node.signs >> axis & 1 ? -centre : centre) +
                         (far ? room.half_size[axis] : -room.half_size[axis]));
  }

  /// Answer of a pixel: the three signs, or one bit.
  int decide(const Node& node, int pixel) const {
    const vec3& dr = rays_[pixel];
    int axis = 0;
    bool inverted = false;
    switch (node.question) {
      case Signs: return (dr[0] < 0) | (dr[1] < 0) << 1 | (dr[2] < 0) << 2;
      case FarFirst: axis = node.face + 1, inverted = true; break;
      case FarSecond: axis = node.face + 2; break;
      case NearFirst: axis = node.face + 1; break;
      case NearSecond: axis = node.face + 2, inverted = true; break;
      case XOrY: axis = 2; break;
      case Exit: axis = node.y_wins ? 0 : 1; break;
    }
    axis %= 3;
    const int a = axis == 0, b = axis == 2 ? 1 : 2;  // the other two axes
    const int corner_a = corner(node, a), corner_b = corner(node, b);
    bool greater_equal = false;
    if (corner_b < 0) greater_equal = true;
    else if (corner_a >= 0)
      greater_equal = corner_a * magnitude(dr[b]) >= corner_b * magnitude(dr[a]);
    return greater_equal != (inverted != (axis == 1));
  }

  static int magnitude(int component) { return component < 0 ? ~component : component; }

  /// Where an answer leads.
  Node next(Node node, int decision) const {
    switch (node.question) {
      case Signs:
        node.signs = decision;
        node.question = XOrY;
        break;
      case XOrY:
        node.y_wins = decision;
        node.question = Exit;
        break;
      case Exit:
        node.face = node.y_wins ? (decision ? 2 : 1) : (decision ? 0 : 2);
        node.left = node.room;
        if (node.depth == world_.room_depth) node.wall = true;
        else try_opening(node, 0);
        ++node.depth;
        break;
      default:
        if (decision) try_opening(node, node.opening + 1);
        else node.question = static_cast<Question>(node.question + 1);
    }
    return node;
  }

  /// The first question about an opening of the face, or the wall behind the last one.
  void try_opening(Node& node, int opening) const {
    const bool negative = node.signs >> node.face & 1;
    const auto& behind = world_.rooms[node.left].neighbours[golden_face(node.face, negative)];
    node.wall = opening == static_cast<int>(behind.size());
    if (node.wall) return;
    node.opening = opening;
    node.room = behind[opening];
    node.question = FarFirst;
  }

  const GoldenWorld& world_;
  const GoldenRays& rays_;
  const int offset_z_;
  std::vector<Waiting> stack_;
};

}  // namespace

GoldenHits trace_4_line(const GoldenWorld& world, const GoldenRays& rays, int y) {
  const auto ends = trace_4_ends(world, rays, y);
  GoldenHits hits;
  std::transform(ends.begin(), ends.end(), hits.begin(), [](const GoldenEnd& e) { return e.hit; });
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
