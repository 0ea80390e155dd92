// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/scene_rom.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "sc/swap/rtl_twin.h"
#include "tb/scene/program_tables.h"
#include "tb/verilate/rtl_plugin.h"
#include "tests/beam/beside.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

enum { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ };

/// A portal and its other side.
struct Link {
  int room, face, portal, to, back;
};
/// All that leaves room 0, and neighbours of its neighbours so that ways back have other numbers.
constexpr Link Links[] = {
    {0, PlusX, 0, 1, 1},  {0, PlusX, 1, 2, 0},   {0, PlusX, 2, 3, 3},   {0, PlusX, 3, 4, 0},
    {0, MinusX, 0, 5, 2}, {0, PlusY, 0, 6, 0},   {0, PlusY, 1, 7, 1},   {0, MinusY, 0, 8, 3},
    {0, MinusY, 1, 9, 0}, {0, MinusY, 2, 10, 2}, {0, PlusZ, 0, 11, 0},  {0, MinusZ, 0, 12, 1},
    {0, MinusZ, 1, 1, 0}, {13, PlusX, 0, 1, 0},  {13, PlusX, 1, 3, 0},  {14, PlusX, 0, 3, 1},
    {14, PlusX, 1, 3, 2}, {5, PlusX, 0, 14, 0},  {5, PlusX, 1, 13, 0},  {7, MinusY, 0, 14, 0},
    {10, PlusY, 0, 6, 1}, {10, PlusY, 1, 8, 0},  {12, PlusZ, 0, 13, 0},
};
constexpr int Rooms = 15;

vec3 half_size_of(int room) { return {10 + room, 200 - room, 32767 - 1000 * room}; }
vec3 place_of(int room) { return {100 * room, -300 * room, room % 2 ? -32768 : 32767}; }

int edges_of(int room, int face, int portal) { return (7 * room + 5 * face + 3 * portal) & 15; }

scene_program hand_made() {
  scene_program program;
  program.rooms.resize(Rooms);
  for (int id = 0; id < Rooms; ++id) {
    program.rooms[id].half_size = half_size_of(id);
    program.rooms[id].position = place_of(id);
  }
  for (const Link& l : Links) {
    program.rooms[l.room].portals[l.face][l.portal] = {
        std::uint16_t(l.to), std::uint8_t(l.back),
        std::uint8_t(edges_of(l.room, l.face, l.portal))};
    program.rooms[l.to].portals[l.face ^ 1][l.back] = {
        std::uint16_t(l.room), std::uint8_t(l.portal),
        std::uint8_t(edges_of(l.to, l.face ^ 1, l.back))};
  }
  return program;
}

struct Answer {
  int room, back;
  bool operator==(const Answer& o) const { return room == o.room && back == o.back; }
  friend std::ostream& operator<<(std::ostream& to, const Answer& a) {
    return to << a.room << " back " << a.back;
  }
};

/// A folder of this process with the table.
class TableFolder {
 protected:
  explicit TableFolder(const scene_program& program) {
    std::ofstream(folder_ / Table) << room_table(program);
    std::filesystem::current_path(folder_.path());
  }
  static constexpr const char* Table = "rooms.hex";

 private:
  const ScratchFolder folder_;
};

/// The RTL with a table of its own.
class scene_rom_rtl : private TableFolder, public rtl_twin<scene_rom> {
 public:
  scene_rom_rtl(const char* name, const scene_program& program)
      : TableFolder(program), rtl_twin<scene_rom>(name, {}, plugin()) {}

 private:
  static std::string plugin() {
    RtlSources sources{"scene_rom", {RACEBEAM_SOURCE_DIR "/rtl/beam/scene_rom.sv"}};
    sources.parameters = {"Rooms=" + std::to_string(Rooms),
                          "RoomFile=\"" + std::string(Table) + "\""};
    return rtl_plugin(sources);
  }
};

template <class Unit>
class SceneRomTest : public testing::Test {
 protected:
  int out(const char* port) { return static_cast<int>(bench[port].value()); }
  Answer answer() { return {out("neighbour_o"), out("back_o")}; }
  Answer look(int room, int face, int portal, int way = LookThrough, int other_signs = 0) {
    const int axis = face / 2;
    bench["room_i"].drive(room);
    bench["look_axis_i"].drive(axis);
    bench["look_signs_i"].drive((other_signs & ~(1 << axis)) | (face & 1) << axis);
    bench["look_portal_i"].drive(portal);
    bench["look_way_i"].drive(way);
    bench.settle();
    return answer();
  }
  /// Portals of a face of room 0, in order.
  static std::vector<Answer> portals_of(int face) {
    std::vector<Answer> found;
    for (const Link& l : Links)
      if (l.room == 0 && l.face == face) found.push_back({l.to, l.back});
    return found;
  }

  scene_program program = hand_made();
  Unit unit{"dut", program};
  UnitBench bench{unit};
};

using Twins = testing::Types<scene_rom, scene_rom_rtl>;
TYPED_TEST_SUITE(SceneRomTest, Twins);

TYPED_TEST(SceneRomTest, SizesAndPlacesAreThoseOfTheTableWhateverIsLookedFor) {
  for (int id = 0; id < Rooms; ++id)
    for (int face = 0; face < 6; ++face)
      for (const int way : {LookThrough, LookNext, LookPrevious}) {
        this->look(id, face, id % MaxPortals, way);
        ASSERT_EQ(this->bench.read("half_size"), half_size_of(id));
        ASSERT_EQ(this->bench.read("position"), place_of(id));
      }
}

TYPED_TEST(SceneRomTest, EveryPortalLeadsToItsRoomAndBack) {
  for (const Link& l : Links) {
    EXPECT_EQ(this->look(l.room, l.face, l.portal), (Answer{l.to, l.back}));
    EXPECT_EQ(this->look(l.to, l.face ^ 1, l.back), (Answer{l.room, l.portal}));
  }
}

TYPED_TEST(SceneRomTest, EdgesAreThoseOfThePortalAskedAboutWhateverTheWay) {
  for (const Link& l : Links)
    for (const int way : {LookThrough, LookNext, LookPrevious}) {
      this->look(l.room, l.face, l.portal, way);
      EXPECT_EQ(this->out("edges_o"), edges_of(l.room, l.face, l.portal));
      this->look(l.to, l.face ^ 1, l.back, way);
      EXPECT_EQ(this->out("edges_o"), edges_of(l.to, l.face ^ 1, l.back));
    }
  this->look(2, PlusX, 3);  // no portal
  EXPECT_EQ(this->out("edges_o"), 0);
}

TYPED_TEST(SceneRomTest, OnlyTheSignOfTheAxisLookedThroughCounts) {
  for (const Link& l : Links)
    for (int others = 0; others < 8; ++others)
      EXPECT_EQ(this->look(l.room, l.face, l.portal, LookThrough, others), (Answer{l.to, l.back}));
}

// Behind a portal, with the face and the portal that lead back.
TYPED_TEST(SceneRomTest, NextAndPreviousWalkTheFaceThatWasLeftAndBack) {
  for (int face = 0; face < 6; ++face) {
    const auto portals = this->portals_of(face);
    Answer at = this->look(0, face, 0);
    for (std::size_t p = 1; p < portals.size(); ++p) {
      at = this->look(at.room, face ^ 1, at.back, LookNext);
      ASSERT_EQ(at, portals[p]) << "face " << face << ", portal " << p;
      EXPECT_EQ(this->look(at.room, face ^ 1, at.back), (Answer{0, static_cast<int>(p)}));
    }
    for (int p = static_cast<int>(portals.size()) - 2; p >= 0; --p) {
      at = this->look(at.room, face ^ 1, at.back, LookPrevious);
      ASSERT_EQ(at, portals[p]) << "face " << face << ", portal " << p << ", on the way back";
    }
  }
}

TYPED_TEST(SceneRomTest, BeyondTheLastPortalAndBeforeTheFirstIsSolid) {
  for (int face = 0; face < 6; ++face) {
    const auto portals = this->portals_of(face);
    const Answer first = portals.front(), last = portals.back();
    EXPECT_EQ(this->look(last.room, face ^ 1, last.back, LookNext).room, SolidRoom) << face;
    EXPECT_EQ(this->look(first.room, face ^ 1, first.back, LookPrevious).room, SolidRoom) << face;
  }
}

TYPED_TEST(SceneRomTest, WithoutAPortalTheFaceIsSolid) {
  for (int face = 0; face < 6; ++face)
    for (int p = static_cast<int>(this->portals_of(face).size()); p < MaxPortals; ++p)
      EXPECT_EQ(this->look(0, face, p).room, SolidRoom) << face << '.' << p;
  for (const int face : {PlusX, PlusY, MinusY, PlusZ, MinusZ})  // room 2 has one portal
    for (const int way : {LookThrough, LookNext, LookPrevious})
      EXPECT_EQ(this->look(2, face, 0, way).room, SolidRoom) << face;
}

TYPED_TEST(SceneRomTest, RoomsThatTheTableDoesNotHaveAreEmptyAndSolid) {
  for (const int id : {Rooms, 512, 4096, 8190, SolidRoom})
    for (int face = 0; face < 6; ++face)
      for (const int way : {LookThrough, LookNext, LookPrevious}) {
        this->look(1, PlusX, 0);
        EXPECT_EQ(this->look(id, face, face % 4, way).room, SolidRoom) << id;
        EXPECT_EQ(this->bench.read("half_size"), (vec3{0, 0, 0})) << id;
        EXPECT_EQ(this->bench.read("position"), (vec3{0, 0, 0})) << id;
      }
}

TYPED_TEST(SceneRomTest, SceneFlagsHaveNoEffect) {
  for (int flags = 63; flags >= 0; --flags) {
    this->bench["scene_flags_i"].drive(flags);
    EXPECT_EQ(this->look(0, PlusX, 2), (Answer{3, 3})) << flags;
    EXPECT_EQ(this->bench.read("half_size"), half_size_of(0)) << flags;
  }
}

// Header, Comb: the answer follows each input alone, without a clock.
TYPED_TEST(SceneRomTest, AnswerFollowsEachInputAlone) {
  const auto set = [this](const char* port, int value) {
    this->bench[port].drive(value);
    this->bench.settle();
    return this->answer();
  };
  EXPECT_EQ(this->look(0, PlusX, 0), (Answer{1, 1}));
  EXPECT_EQ(set("look_portal_i", 1), (Answer{2, 0}));
  EXPECT_EQ(set("look_axis_i", 1), (Answer{7, 1}));
  EXPECT_EQ(set("look_signs_i", 2), (Answer{9, 0}));
  EXPECT_EQ(set("look_axis_i", 0), (Answer{2, 0}));
  EXPECT_EQ(set("look_signs_i", 1).room, SolidRoom);
  EXPECT_EQ(set("room_i", 1), (Answer{0, 0})) << "back to room 0";
  EXPECT_EQ(set("look_way_i", LookNext), (Answer{2, 0}));
  EXPECT_EQ(set("look_way_i", LookPrevious).room, SolidRoom);
  EXPECT_EQ(set("look_portal_i", 0).room, SolidRoom);
  EXPECT_EQ(set("look_way_i", LookNext), (Answer{3, 0})) << "from room 13";
  EXPECT_EQ(this->bench.read("position"), place_of(1));
  set("room_i", 4);
  EXPECT_EQ(this->bench.read("position"), place_of(4));
  EXPECT_EQ(this->bench.read("half_size"), half_size_of(4));
}

TYPED_TEST(SceneRomTest, NoInputIsMissedUnderRandomOnes) {
  auto& bench = this->bench;
  const auto check = [&] {
    const int id = bench["room_i"].value(), axis = bench["look_axis_i"].value();
    const bool known = id < Rooms;
    ASSERT_EQ(bench.read("half_size"), known ? half_size_of(id) : vec3{});
    ASSERT_EQ(bench.read("position"), known ? place_of(id) : vec3{});
    const portal_row want = scene_rom_core::look(
        this->program.rooms, id, axis, bench["look_signs_i"].value() >> axis & 1,
        bench["look_portal_i"].value(), bench["look_way_i"].value());
    ASSERT_EQ(this->answer(), (Answer{want.room, want.back}));
    ASSERT_EQ(this->out("edges_o"), want.edges);
  };
  std::minstd_rand rooms(3);
  const auto clock = [&] { bench["room_i"].drive(static_cast<int>(rooms() % (Rooms + 2))); };
  run_beside(bench, 13, 20000, clock, check);
}

}  // namespace
}  // namespace racebeam
