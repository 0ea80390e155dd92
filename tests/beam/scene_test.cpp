// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/scene.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "sc/beam/sequencer.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {
namespace {

constexpr int W = SceneWindows, P = ScenePortals, B = SceneBlocked, H = SceneHeights,
              U = SceneTunnel, N = SceneNarrow;
constexpr int Solid = SolidRoom;
/// The flag sets of the demo (contract 17.1).
const std::vector<int> DemoScenes = {W | B, U, H, H | B, W | P | B | N, U | N, H | N};

constexpr int room_id(int i, int j, int k) { return k << 8 | j << 4 | i; }

/// A face to look through.
struct Face {
  int axis;
  bool negative;
};
constexpr Face Faces[6] = {{0, true}, {0, false}, {1, true}, {1, false}, {2, true}, {2, false}};

struct Answer {
  vec3 position, half_size;
  int neighbour;
  bool operator==(const Answer& o) const {
    return position == o.position && half_size == o.half_size && neighbour == o.neighbour;
  }
  friend std::ostream& operator<<(std::ostream& to, const Answer& a) {
    for (const auto& v : {a.position, a.half_size}) to << v[0] << "," << v[1] << "," << v[2] << " ";
    return to << a.neighbour;
  }
};

/// Contract 17.2.
Answer reference(int flags, int id, Face face) {
  const int i = id & 15, j = id >> 4 & 15, k = id >> 8;
  const bool windows = flags & W, portals = flags & P, blocked = flags & B, tunnel = flags & U;
  const int mw = flags & N ? 160 : 256, sw = flags & N ? 352 : 256;
  const bool oo = blocked && i % 2 == 1 && j % 2 == 1;
  const bool main_type = k == 0 || oo;
  Answer a;
  if (main_type) {
    a.position = {256 * i, 0, 256 * j};
    a.half_size = {(i % 2 ? sw : mw) / 2, 256, (j % 2 ? sw : mw) / 2};
    if (flags & H) a.half_size[1] = 256 * (1 + (i % 2 == 0) + (j % 2 == 0));
    if (portals && oo) {
      a.half_size[k == 0 ? 2 : 0] = 80;
      a.half_size[1] = 160;
    }
    if (tunnel) {
      static constexpr int tx[8] = {0, -2, -3, -2, 0, 2, 3, 2};
      static constexpr int ty[8] = {3, 2, 0, -2, -3, -2, 0, 2};
      a.half_size[0] = 256;
      a.position[0] = 64 * tx[j % 8];
      a.position[1] = 64 * ty[j % 8];
    }
  } else {
    a.position = {256 * i, -272, 256 * j};
    a.half_size = {96, 16, 96};
  }
  for (int axis = 0; axis < 3; ++axis) {
    a.position[axis] = (a.position[axis] + 2048 + 4096) % 4096 - 2048;
  }

  const int d = face.negative ? -1 : 1;
  a.neighbour = Solid;
  if (face.axis == 0 && main_type) {
    const bool edge = i == (d < 0 ? 0 : 8);
    const bool open = !blocked || (portals ? !(oo && k == 1) : j % 2 == 0);
    if (!edge && open) a.neighbour = room_id((i + d) & 15, j, k);
  } else if (face.axis == 2 && main_type) {
    const bool edge = !tunnel && j == (d < 0 ? 0 : 8);
    const bool open = !blocked || (portals ? !(oo && k == 0) : i % 2 == 0);
    const bool toggles = blocked && portals && i % 2 == 1;
    if (!edge && open) a.neighbour = room_id(i, (j + d) & 15, toggles ? !k : k);
  } else if (face.axis == 1 && windows && !oo) {
    if (face.negative && k == 0) a.neighbour = room_id(i, j, 1);
    if (!face.negative && k == 1) a.neighbour = room_id(i, j, 0);
  }
  return a;
}

template <class Unit>
class SceneTest : public testing::Test {
 protected:
  explicit SceneTest(const knobs& k = {}) : unit("dut", k), bench(unit) {}

  /// What the unit answers; `other_signs` go to the axes that are not asked for.
  Answer look(int flags, int id, Face face, int other_signs = 0) {
    bench["scene_flags_i"].drive(flags);
    bench["room_i"].drive(id);
    bench["look_axis_i"].drive(face.axis);
    bench["look_signs_i"].drive((other_signs & ~(1 << face.axis)) | face.negative << face.axis);
    bench.settle();
    return {bench.read("position"), bench.read("half_size"),
            static_cast<int>(bench["neighbour_o"].value())};
  }

  /// All rooms that a ray can come to from the camera's rooms (i = 4, k = 0).
  std::set<int> reachable(int flags) {
    std::set<int> found;
    std::vector<int> open;
    for (int j = 0; j <= (flags & U ? 15 : 8); ++j) open.push_back(room_id(4, j, 0));
    while (!open.empty()) {
      const int id = open.back();
      open.pop_back();
      if (!found.insert(id).second) continue;
      for (const Face& face : Faces) {
        const int next = look(flags, id, face).neighbour;
        if (next != Solid) open.push_back(next);
      }
    }
    return found;
  }

  Unit unit;
  UnitBench bench;
};

using Twins = testing::Types<scene, own_rtl<scene>>;
TYPED_TEST_SUITE(SceneTest, Twins);

// Contract 20.4.
TYPED_TEST(SceneTest, LookupsOfTheContract) {
  struct Row {
    int flags, i, j, k;
    Face face;
    vec3 position, half_size;
    int neighbour;
  };
  constexpr Face mx{0, true}, px{0, false}, my{1, true}, py{1, false}, mz{2, true}, pz{2, false};
  const Row rows[] = {
      {W | B, 4, 0, 0, mx, {1024, 0, 0}, {128, 256, 128}, room_id(3, 0, 0)},
      {W | B, 4, 0, 0, pz, {1024, 0, 0}, {128, 256, 128}, room_id(4, 1, 0)},
      {W | B, 4, 0, 0, my, {1024, 0, 0}, {128, 256, 128}, room_id(4, 0, 1)},
      {W | B, 4, 0, 0, py, {1024, 0, 0}, {128, 256, 128}, Solid},
      {W | B, 4, 0, 1, py, {1024, -272, 0}, {96, 16, 96}, room_id(4, 0, 0)},
      {W | B, 3, 0, 0, pz, {768, 0, 0}, {128, 256, 128}, Solid},
      {W | B, 4, 1, 0, px, {1024, 0, 256}, {128, 256, 128}, Solid},
      {W | B, 5, 5, 0, px, {1280, 0, 1280}, {128, 256, 128}, Solid},
      {W | B, 8, 2, 0, px, {-2048, 0, 512}, {128, 256, 128}, Solid},
      {W | B, 4, 8, 0, pz, {1024, 0, -2048}, {128, 256, 128}, Solid},
      {W | B, 5, 5, 1, mz, {1280, 0, 1280}, {128, 256, 128}, Solid},
      {W | B, 5, 4, 0, pz, {1280, 0, 1024}, {128, 256, 128}, Solid},
      {U, 4, 0, 0, mx, {0, 192, 0}, {256, 256, 128}, room_id(3, 0, 0)},
      {U, 4, 1, 0, px, {-128, 128, 256}, {256, 256, 128}, room_id(5, 1, 0)},
      {U, 8, 2, 0, px, {-192, 0, 512}, {256, 256, 128}, Solid},
      {U, 4, 8, 0, pz, {0, 192, -2048}, {256, 256, 128}, room_id(4, 9, 0)},
      {H, 4, 0, 0, pz, {1024, 0, 0}, {128, 768, 128}, room_id(4, 1, 0)},
      {H, 4, 0, 0, my, {1024, 0, 0}, {128, 768, 128}, Solid},
      {H, 5, 5, 0, px, {1280, 0, 1280}, {128, 256, 128}, room_id(6, 5, 0)},
      {H, 4, 5, 0, px, {1024, 0, 1280}, {128, 512, 128}, room_id(5, 5, 0)},
      {W | P | B | N, 4, 0, 0, my, {1024, 0, 0}, {80, 256, 80}, room_id(4, 0, 1)},
      {W | P | B | N, 3, 0, 0, pz, {768, 0, 0}, {176, 256, 80}, room_id(3, 1, 1)},
      {W | P | B | N, 5, 5, 0, px, {1280, 0, 1280}, {176, 160, 80}, room_id(6, 5, 0)},
      {W | P | B | N, 5, 5, 1, mz, {1280, 0, 1280}, {80, 160, 176}, room_id(5, 4, 0)},
      {W | P | B | N, 5, 4, 0, pz, {1280, 0, 1024}, {176, 256, 80}, room_id(5, 5, 1)},
      {W | P | B | N, 4, 5, 0, px, {1024, 0, 1280}, {80, 256, 176}, room_id(5, 5, 0)},
      {U | N, 4, 0, 0, pz, {0, 192, 0}, {256, 256, 80}, room_id(4, 1, 0)},
      {U | N, 4, 1, 0, px, {-128, 128, 256}, {256, 256, 176}, room_id(5, 1, 0)},
      {H | N, 5, 5, 0, px, {1280, 0, 1280}, {176, 256, 176}, room_id(6, 5, 0)},
  };
  for (const Row& row : rows) {
    const Answer want{row.position, row.half_size, row.neighbour};
    EXPECT_EQ(this->look(row.flags, room_id(row.i, row.j, row.k), row.face), want)
        << "flags " << row.flags << ", room " << row.i << "," << row.j << "," << row.k << ", axis "
        << row.face.axis << (row.face.negative ? " -" : " +");
  }
}

// Contract 12.1, its tables as they stand, on the 9 x 9 grid.
TYPED_TEST(SceneTest, PillarsWithWindowsFollowTheTablesOfSection12) {
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= 8; ++j)
      for (int i = 0; i <= 8; ++i)
        for (const Face& face : Faces) {
          const bool pillar = i % 2 == 1 && j % 2 == 1;
          const int x = i == 8 ? -2048 : 256 * i, z = j == 8 ? -2048 : 256 * j;
          Answer want{{x, 0, z}, {128, 256, 128}, Solid};
          if (k == 1 && !pillar) want = {{x, -272, z}, {96, 16, 96}, Solid};
          const int next = face.negative ? -1 : 1;
          if (face.axis == 0 && k == 0 && j % 2 == 0 && i + next >= 0 && i + next <= 8)
            want.neighbour = room_id(i + next, j, 0);
          if (face.axis == 2 && k == 0 && i % 2 == 0 && j + next >= 0 && j + next <= 8)
            want.neighbour = room_id(i, j + next, 0);
          if (face.axis == 1 && !pillar && k == !face.negative) want.neighbour = room_id(i, j, !k);
          ASSERT_EQ(this->look(W | B, room_id(i, j, k), face), want)
              << i << "," << j << "," << k << " axis " << face.axis << " negative "
              << face.negative;
        }
}

// Contract 17.2: every scene of the demo, every room id, every face.
TYPED_TEST(SceneTest, EveryDemoSceneFollowsTheRulesOfSection17) {
  for (const int flags : DemoScenes)
    for (int id = 0; id < 511; ++id)
      for (const Face& face : Faces)
        ASSERT_EQ(this->look(flags, id, face, id * 5 >> 2), reference(flags, id, face))
            << "flags " << flags << ", id " << id << ", axis " << face.axis << " negative "
            << face.negative;
}

// Contract 12.1: "any room with id 511 has neighbour 4 in all directions".
TYPED_TEST(SceneTest, SolidRoomLeadsBackToRoom4) {
  for (const int flags : DemoScenes)
    for (const Face& face : Faces)
      EXPECT_EQ(this->look(flags, Solid, face).neighbour, 4) << flags << " " << face.axis;
}

// Every portal has two sides: leaving a room and turning back leads to the same room.
TYPED_TEST(SceneTest, NeighbourOfTheNeighbourIsTheRoom) {
  for (const int flags : DemoScenes) {
    const auto rooms = this->reachable(flags);
    EXPECT_GE(rooms.size(), 65u) << flags;  // 81 less the 16 pillars
    for (const int id : rooms)
      for (const Face& face : Faces) {
        const int next = this->look(flags, id, face).neighbour;
        if (next == Solid) continue;
        EXPECT_EQ(this->look(flags, next, {face.axis, !face.negative}).neighbour, id)
            << "flags " << flags << ", rooms " << id << " and " << next;
      }
  }
}

// A portal is where the faces of its two rooms coincide (but for the tunnel's copies of a room).
TYPED_TEST(SceneTest, NeighboursTouchInTheCommonPlane) {
  for (const int flags : DemoScenes)
    for (const int id : this->reachable(flags))
      for (const Face& face : Faces) {
        const Answer from = this->look(flags, id, face);
        if (from.neighbour == Solid || (flags & U && face.axis == 0)) continue;
        const Answer to = this->look(flags, from.neighbour, face);
        const int distance = to.position[face.axis] - from.position[face.axis];
        const int sizes = from.half_size[face.axis] + to.half_size[face.axis];
        EXPECT_EQ(wrap_signed(face.negative ? -distance : distance, 12), sizes)
            << "flags " << flags << ", room " << id << ", axis " << face.axis;
      }
}

// Contract 17.2: the tunnel has no end in z and the same shape every 8 rooms.
TYPED_TEST(SceneTest, TunnelGoesRoundInZ) {
  for (int j = 0; j < 16; ++j) {
    const Answer here = this->look(U, room_id(4, j, 0), {2, false});
    EXPECT_EQ(here.neighbour, room_id(4, (j + 1) % 16, 0));
    const Answer later = this->look(U, room_id(4, (j + 8) % 16, 0), {2, false});
    EXPECT_EQ(here.position[0], later.position[0]);
    EXPECT_EQ(here.position[1], later.position[1]);
  }
}

TYPED_TEST(SceneTest, TellsNothingOfEdgesUnlessAsked) {
  for (const int flags : DemoScenes)
    for (const Face& face : Faces) {
      this->look(flags, room_id(4, 3, 0), face);
      EXPECT_EQ(this->bench["edges_o"].value(), 0u) << flags;
    }
}

constexpr knobs edges_in_the_table() {
  knobs k;
  k.skip_shared_edges = SharedEdgesTable;
  return k;
}

template <class Unit>
class SceneEdges : public SceneTest<Unit> {
 protected:
  SceneEdges() : SceneTest<Unit>(edges_in_the_table()) {}
};
TYPED_TEST_SUITE(SceneEdges, Twins);

// Header: bits 0 and 2 are the edges towards positive and negative coordinates of the axis two
// after the face's, bits 1 and 3 those of the axis after.
TYPED_TEST(SceneEdges, AreThoseThatLieOnOrBeyondTheRoomBehind) {
  int on = 0, off = 0;
  for (const int flags : DemoScenes)
    for (const int id : this->reachable(flags))
      for (const Face& face : Faces) {
        const Answer here = this->look(flags, id, face, 7 - id % 8);
        if (here.neighbour == Solid) continue;
        const int edges = static_cast<int>(this->bench["edges_o"].value());
        const Answer behind = this->look(flags, here.neighbour, face);
        for (int bit = 0; bit < 4; ++bit) {
          const int axis = (face.axis + (bit % 2 ? 1 : 2)) % 3, side = bit < 2 ? 1 : -1;
          const int beyond = wrap_signed(side * (here.position[axis] - behind.position[axis]), 12) +
                             here.half_size[axis] - behind.half_size[axis];
          ASSERT_EQ(bit_of(edges, bit), beyond >= 0)
              << "flags " << flags << ", room " << id << ", axis " << face.axis << ", bit " << bit;
          ++(beyond >= 0 ? on : off);
        }
      }
  EXPECT_GT(on, 1000);
  EXPECT_GT(off, 1000);
}

}  // namespace
}  // namespace racebeam
