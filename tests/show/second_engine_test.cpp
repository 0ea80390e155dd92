// What works with any engine works with one that is not in the product.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "sc/beam/engine.h"
#include "sc/beam/knobs.h"
#include "tb/base/errors.h"
#include "tb/report/manifest.h"
#include "tb/report/stats_json.h"
#include "tb/report/stats_table.h"
#include "tb/show/open_show.h"
#include "tb/show/run.h"
#include "tb/show/set_knob.h"
#include "tests/support/json.h"
#include "tests/support/scene_text.h"
#include "tests/support/scratch_engine.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

constexpr const char* Good =
    "engine = \"scratch\"\nzoom = 2.5\neye = [1, -0.5, 1000]\n"
    "sky = \"#0a80ff\"\n";

AnySceneResult read(const std::string& text) {
  return read_any_scene(text, "test", kinds_with_scratch());
}

std::string faults_in(const std::string& text) { return read(text).faults.text("f"); }

Show scratch_show() { return {read(Good).scene, "hash"}; }

template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneKinds, TheKeyChoosesTheReader) {
  const AnySceneResult scratch = read(Good);
  ASSERT_TRUE(scratch.scene) << scratch.faults.text("f");
  EXPECT_EQ(&scratch.scene->engine(), &scratch_engine());
  EXPECT_EQ(scratch.scene->name(), "test");
  const AnySceneResult rooms = read(TwoRooms);
  ASSERT_TRUE(rooms.scene) << rooms.faults.text("f");
  EXPECT_EQ(&rooms.scene->engine(), &beam_engine());
  EXPECT_EQ(rooms.scene->counts(), "2 rooms, 1 portals");
}

TEST(SceneKinds, AnUnknownEngineIsAFaultWithItsPlace) {
  EXPECT_EQ(faults_in("engine = \"bean\"\n"),
            "f:1:10: 'engine' is 'bean'\n  help: it must be one of beam, sphere, block, voxel, "
            "scratch\n");
}

TEST(SceneKinds, AReaderHasKeysOfItsOwn) {
  EXPECT_THAT(faults_in("engine = \"scratch\"\noverlap = true\n"),
              HasSubstr("f:2:1: unknown key 'overlap'"));
  EXPECT_THAT(faults_in("sky = \"#000000\"\n" + std::string(TwoRooms)),
              HasSubstr("f:1:1: unknown key 'sky'"));
}

TEST(TableReaderTest, TakesDecimalsAndColours) {
  EXPECT_TRUE(read("engine = \"scratch\"\nzoom = 2\n").scene) << "whole numbers are numbers";
  const AnySceneResult good = read(Good);
  const auto& seen = static_cast<const scratch_tables&>(good.scene->tables());
  EXPECT_EQ(seen.zoom, 2.5);
  EXPECT_THAT(seen.eye, testing::ElementsAre(1, -0.5, 1000));
  EXPECT_EQ(seen.sky, 0x0a80ffU);
}

TEST(TableReaderTest, RefusesOtherNumbersAndColours) {
  const std::string own = "engine = \"scratch\"\n";
  EXPECT_EQ(faults_in(own + "zoom = 0.25\n"),
            "f:2:8: 'zoom' is 0.25\n  help: it must be in 0.5..8\n");
  EXPECT_THAT(faults_in(own + "zoom = nan\n"), HasSubstr("not a finite number"));
  EXPECT_THAT(faults_in(own + "zoom = \"2\"\n"), HasSubstr("it must be a number 0.5..8"));
  EXPECT_THAT(faults_in(own + "eye = [0, 0]\n"), HasSubstr("it must be three numbers, [x, y, z]"));
  EXPECT_THAT(faults_in(own + "eye = [0, 0, 1000.5]\n"), HasSubstr("f:2:14: 'eye' is 1000.5"));
  for (const char* colour : {"0a80ff", "#0a80f", "#0a80ffff", "#0a80fg", "#-a80ff", ""})
    EXPECT_THAT(
        faults_in(own + "sky = \"" + colour + "\"\n"),
        HasSubstr("f:2:7: 'sky' is '" + std::string(colour) + "'\n  help: write red, green"));
  EXPECT_THAT(faults_in(own + "sky = 255\n"), HasSubstr("it must be a colour"));
}

TEST(AnyShow, IsWhatItsSceneSays) {
  const Show show = scratch_show();
  EXPECT_EQ(&show.engine(), &scratch_engine());
  EXPECT_EQ(show.frames(), 5);
  EXPECT_EQ(show.part(3), "picture 3");
  EXPECT_FALSE(show.of_rooms());
  EXPECT_EQ(show.program(), nullptr);
  EXPECT_EQ(static_cast<const scratch_tables*>(show.tables())->zoom, 2.5);
}

TEST(AnyShow, TellsWhoseItIs) {
  EXPECT_EQ(error_of([] { expect_engine(scratch_show(), "beam"); }),
            "test is a scene for scratch; --engine scratch or leave --engine out");
  EXPECT_EQ(error_of([] { expect_engine(Show(), "beam"); }), "");
  EXPECT_THAT(error_of([] { expect_engine(Show(), "beem"); }), HasSubstr("did you mean 'beam'"));
  EXPECT_EQ(error_of([] { expect_rooms(scratch_show(), "view"); }),
            "view is for scenes of box rooms; test is a scene for scratch");
}

TEST(AnyKnobs, AreSetByTheirOwnTable) {
  const Show show = scratch_show();
  const knob_values k = knobs_of(show, {"cells=32", "order=columns"});
  EXPECT_EQ(k.of("cells"), 32);
  EXPECT_EQ(k.of("order"), 1);
  EXPECT_EQ(knobs_text(k), "cells=32, order=columns");
  EXPECT_EQ(knobs_text(show.standard_knobs()), "default");
  scratch_knobs back;
  put_values(scratch_table(), scratch_rows(), k, back);
  EXPECT_EQ(back.cells, 32);
  EXPECT_EQ(error_of([&] { knobs_of(show, {"cells=33"}); }), "too many cells");
  EXPECT_THAT(error_of([&] { knobs_of(show, {"cells=65"}); }), HasSubstr("1..64 cells"));
}

TEST(AnyKnobs, OneOfAnotherEngineIsTold) {
  EXPECT_THAT(error_of([] { knobs_of(scratch_show(), {"fifo_entries=8"}); }),
              HasSubstr("knob fifo_entries is one of beam"));
}

TEST(AnyKnobs, AStructTakesItsOwnOnly) {
  const knob_values scratch = scratch_show().standard_knobs();
  EXPECT_THROW(knobs{scratch}, std::logic_error);
  knobs k;
  k.fifo_entries = 3;
  const knob_values values = k;
  EXPECT_EQ(values.of("fifo_entries"), 3);
  EXPECT_EQ(knobs(values), k);
  EXPECT_NE(values, knob_values(knobs()));
}

TEST(AnyStats, PicturesHaveTimesAndCountersByPixel) {
  StatsReport report(scratch_engine(), "test", "tlm", scratch_show().standard_knobs());
  VgaFrame picture;
  picture.width = 20;
  picture.height = 10;
  picture.bits = 5;
  for (const std::uint64_t words : {100, 300})
    report.add(0, "sky", {{words}, {{1, 2, 3}}, {}}, picture, false, {}, {words * 50, 2});
  const Json document = Json::parse(report.text());
  EXPECT_EQ(document.at("version"), 3);
  EXPECT_EQ(document.at("engine"), "scratch");
  EXPECT_EQ(document.at("knobs"), (Json{{"cells", 8}, {"order", "rows"}}));
  const Json second = document.at("pictures")[1];
  EXPECT_EQ(second.at("picture"), 0);
  EXPECT_EQ(second.at("clocks"), 15000);
  EXPECT_EQ(second.at("frames"), 2);
  EXPECT_EQ(second.at("counters").at("words"), 300);
  EXPECT_EQ(second.at("counters").at("fill"), (Json{1, 2, 3, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(second.at("per_pixel"), (Json{{"clocks", 75.0}, {"words", 1.5}}));
  const Json total = document.at("total");
  EXPECT_EQ(total.at("pictures"), 2);
  EXPECT_EQ(total.at("clocks"), 20000);
  EXPECT_EQ(total.at("frames"), 4);
  EXPECT_EQ(total.at("per_pixel"), (Json{{"clocks", 50.0}, {"words", 1.0}}));
}

TEST(AnyStats, TheTableHasItsColumns) {
  const frame_counts counts{{300}, {}, {}};
  EXPECT_THAT(table_header(scratch_engine(), false), testing::EndsWith("    words\n"));
  EXPECT_THAT(table_row(scratch_engine(), 2, "sky", counts, {}, false),
              testing::EndsWith("      300\n"));
}

TEST(AnyStats, TheManifestHasItsKnobs) {
  Manifest manifest;
  manifest.k = knobs_of(scratch_show(), {"cells=9"});
  EXPECT_EQ(manifest.settings().at("knobs").dump(), R"({"cells":9,"order":"rows"})");
}

}  // namespace
}  // namespace racebeam
