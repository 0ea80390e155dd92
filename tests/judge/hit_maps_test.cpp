// Hit maps of chips beside those of their golden tracers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/hit_maps.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "tb/bench/benches.h"
#include "tb/judge/goldens.h"
#include "tb/show/open_show.h"

namespace racebeam {
namespace {

struct Maps {
  HitMap chip, golden;
  ChipBench::Frame frame;
};

Maps maps_of(const Show& show, int frame) {
  const knob_values k = show.standard_knobs();
  const auto bench =
      bench_of(show.engine())
          .make("tlm", {show.engine(), k, show.tables(), show.frames()}, {false, false, true});
  bench->seek(frame);
  const HitKind& kind = hits_of(show.engine());
  ChipBench::Frame drawn = bench->render();
  return {kind.chip(show, k, drawn), kind.golden(show, k, frame), std::move(drawn)};
}

double share(std::uint64_t part, std::uint64_t of) { return double(part) / double(of); }

struct Case {
  const char* scene;
  int frame;
  double wrong, inner;  ///< at most, of all and away from edges
};

class HitMaps : public testing::TestWithParam<Case> {};

TEST_P(HitMaps, OfTheChipIsTheGoldenOneButForItsEdges) {
  const Maps maps = maps_of(open_show(GetParam().scene), GetParam().frame);
  const HitErrors errors = hit_errors(maps.chip, maps.golden);
  EXPECT_EQ(errors.pixels, maps.frame.picture.pixels());
  EXPECT_LE(share(errors.wrong, errors.pixels), GetParam().wrong);
  EXPECT_LE(share(errors.inner_wrong, errors.inner), GetParam().inner);
  EXPECT_GT(std::set<int>(maps.chip.objects.begin(), maps.chip.objects.end()).size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, HitMaps,
    testing::Values(Case{"demo", 5000, 0.02, 0.01}, Case{"demo", 700, 0.05, 0.01},
                    Case{"demo", 7223, 0.15, 0.12} /* much is given up */,
                    Case{"house", 0, 0.02, 0.01}, Case{"maze", 40, 0.02, 0.01},
                    Case{"museum", 100, 0.02, 0.01}, Case{"spiral", 50, 0.03, 0.01},
                    Case{"sphere/inside", 20, 0.01, 0.001}, Case{"block/quad", 0, 0.01, 0.001}));

TEST(HitMaps, CountTheWrongHitsOfTheJudge) {
  const Show show = open_show("sphere/inside");
  const Maps maps = maps_of(show, 20);
  const PictureErrors errors =
      golden_of(show.engine())
          ->compare(show.tables(), show.standard_knobs(), 20, maps.frame.picture, 1);
  EXPECT_EQ(hit_errors(maps.chip, maps.golden).wrong, errors.wrong_hits);
  EXPECT_GT(errors.wrong_hits, 0u);
}

TEST(HitMaps, EyeInsideASphereIsAnObject) {
  const Maps maps = maps_of(open_show("sphere/inside"), 0);
  EXPECT_EQ(maps.chip.at(160, 120), HitMap::Inside);
  EXPECT_EQ(maps.golden.at(160, 120), HitMap::Inside);
}

TEST(HitMaps, PixelsNextToAnotherObjectAreNoInnerOnes) {
  const HitMap golden{4, 3, {1, 1, 1, 2, 1, 1, 1, 2, 1, 1, 1, 2}};
  const HitMap chip{4, 3, {1, 7, 7, 2, 1, 1, 1, 2, 1, 1, 1, 2}};
  const HitErrors errors = hit_errors(chip, golden);
  EXPECT_EQ(errors.pixels, 12u);
  EXPECT_EQ(errors.wrong, 2u);
  EXPECT_EQ(errors.inner, 6u);
  EXPECT_EQ(errors.inner_wrong, 1u);
  EXPECT_THROW(hit_errors({1, 1, {0}}, golden), std::invalid_argument);
}

TEST(HitMaps, HaveAColourForEachObjectAndNoneForNothing) {
  VgaFrame frame;
  HitMap map{20, 1, {}};
  for (int object = HitMap::Inside; object < 18; ++object) map.objects.push_back(object);
  show_hits(frame, map);
  EXPECT_EQ(frame.bits, 8);
  EXPECT_TRUE(frame.whole());
  EXPECT_EQ(frame.colour(1), 0u);
  std::set<std::uint32_t> colours;
  for (std::size_t n = 0; n < 20; ++n) colours.insert(frame.colour(n));
  EXPECT_EQ(colours.size(), 20u);
}

}  // namespace
}  // namespace racebeam
