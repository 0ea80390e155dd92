// Errors by cause add up to the difference from a picture that does not move with the knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/error_causes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "tb/judge/tlm_pictures.h"
#include "tb/show/open_show.h"
#include "tests/support/core_picture.h"

namespace racebeam {
namespace {

const Show& demo() {
  static const Show show;
  return show;
}

std::vector<int> errors_by_cause(const Show& show, int frame, const knobs& k,
                                 PictureReference reference) {
  const ErrorChain chain(show, k, reference);
  ErrorChain::Links links;
  return chain.by_cause(frame, TlmPictures(show, frame, k).picture(k), chain.end().picture(frame),
                        links);
}

struct Judged {
  std::map<std::string, int> causes;
  int difference;  ///< of the cores' picture from the reference
};

Judged judge(int frame, const knobs& k, PictureReference reference = PictureReference::Geometry,
             const Show& show = demo()) {
  const GoldenPicture ideal = ReferencePicture(show, reference, k, {}).picture(frame);
  const std::vector<int> pixels = errors_by_cause(show, frame, k, reference);
  const auto& causes = error_causes(reference);
  EXPECT_EQ(pixels.size(), causes.size());
  Judged judged{{}, golden_difference(core_picture(frame, k, show.program()), ideal)};
  for (std::size_t i = 0; i < causes.size(); ++i) judged.causes[causes[i].name] = pixels.at(i);
  const int sum = std::accumulate(pixels.begin(), pixels.end(), 0);
  EXPECT_EQ(sum, judged.difference) << "they add up";
  return judged;
}

template <class Change>
knobs with(const Change& change) {
  knobs k;
  change(k);
  return k;
}

std::string largest(const Judged& judged) {
  return std::max_element(judged.causes.begin(), judged.causes.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

TEST(ErrorCauses, AddUpWithAnyKnobs) {
  const knobs other = with([](knobs& k) {
    k.dr_bits = 12;
    k.stepping = SteppingFractionDr2;
    k.ddr_fraction_bits = 7;
    k.skip_shared_edges = 1;
    k.bisection = BisectionFloor;
    k.head_start = 100;
    k.interlace = 0;
  });
  for (const int frame : {3900, 7167}) {
    judge(frame, {});
    judge(frame, other);
    judge(frame, other, PictureReference::Trace4);
  }
}

TEST(ErrorCauses, AddUpInAScene) {
  const Show show = open_show("museum");
  judge(show.frames() / 2, show.standard_knobs(), PictureReference::Geometry, show);
}

TEST(ErrorCauses, PutAKnobDownToItsOwnCause) {
  const auto expect_largest = [](const char* cause, int frame, const knobs& k) {
    EXPECT_EQ(largest(judge(frame, k)), cause);
  };
  expect_largest("starved", 7167, with([](knobs& k) { k.clocks_per_pixel = 1; }));
  expect_largest("room_depth", 7215, with([](knobs& k) { k.max_room_depth = 2; }));
  expect_largest("multiplier_cut", 1023, with([](knobs& k) { k.partial_products_cut = 8; }));
  expect_largest("corner_shift", 1023, with([](knobs& k) { k.corner_factor_bits = 6; }));
  expect_largest("ray_bits", 1023, with([](knobs& k) { k.dr_bits = 8; }));
}

TEST(ErrorCauses, SplitTheRoundingOfRays) {
  constexpr int Frame = 1023;
  const auto chip = judge(Frame, {}).causes;
  EXPECT_GT(chip.at("ray_steps"), 0);
  EXPECT_GT(chip.at("ray_bits"), 0);
  const auto whole = judge(Frame, with([](knobs& k) { k.dr_bits = 13; })).causes;
  EXPECT_EQ(whole.at("ray_bits"), 0);
  const auto exact = judge(Frame, with([](knobs& k) { k.stepping = SteppingFraction; })).causes;
  EXPECT_EQ(exact.at("ray_steps"), 0);
  EXPECT_EQ(exact.count("corner_wrap"), 0);
}

// Against trace_4 rays are as meant.
TEST(ErrorCauses, OfTrace4HaveNoRounding) {
  const Judged chip = judge(1023, {}, PictureReference::Trace4);
  EXPECT_EQ(chip.causes.count("ray_bits"), 0);
  EXPECT_EQ(chip.causes.at("ray_knobs"), 0);
  EXPECT_EQ(chip.causes.at("corner_wrap"), 0) << "no corner is too far here";
  EXPECT_GT(chip.difference, 0);
  const knobs wide = with([](knobs& k) { k.dr_bits = 13; });
  EXPECT_GT(judge(1023, wide, PictureReference::Trace4).causes.at("ray_knobs"), 0);
}

TEST(ErrorCauses, OfTheBaseAreThoseOfGeometry) {
  constexpr int Frame = 1023;
  EXPECT_EQ(&error_causes(PictureReference::Base), &error_causes(PictureReference::Geometry));
  EXPECT_EQ(errors_by_cause(demo(), Frame, {}, PictureReference::Base),
            errors_by_cause(demo(), Frame, {}, PictureReference::Geometry));
}

// The links from `interval_stack_depth` on, and from `hurry_threshold` on.
TEST(ErrorCauses, PointsShareTheLinksThatDoNotSeeWhereTheyDiffer) {
  const auto keys = [](const knobs& k) {
    return ErrorChain(demo(), k, PictureReference::Geometry).keys();
  };
  const auto chip = keys({});
  EXPECT_EQ(keys(with([](knobs& k) { k.hurry_threshold = 100; })), chip);
  const auto stack = keys(with([](knobs& k) { k.interval_stack_depth = 2; }));
  ASSERT_EQ(stack.size(), chip.size());
  for (std::size_t i = 0; i < chip.size(); ++i) EXPECT_EQ(stack[i] == chip[i], i >= 2) << i;
  const auto fifo = keys(with([](knobs& k) {
    k.fifo_short_length_bits = 4;
    k.fifo_merge = 0;
    k.head_start = 8;
  }));
  for (std::size_t i = 0; i < chip.size(); ++i) EXPECT_EQ(fifo[i] == chip[i], i >= 1) << i;
  const auto corners = keys(with([](knobs& k) { k.corner_rounding = 1; }));
  EXPECT_NE(corners[3], chip[3]);
  EXPECT_TRUE(std::equal(chip.begin() + 4, chip.end(), corners.begin() + 4, corners.end()));
}

TEST(ErrorCauses, LinksOfAnotherPointGiveTheSameNumbers) {
  constexpr int Frame = 7167;
  const ErrorChain chip(demo(), {}, PictureReference::Geometry);
  const GoldenPicture end = chip.end().picture(Frame);
  ErrorChain::Links links;
  chip.by_cause(Frame, TlmPictures(demo(), Frame, {}).picture({}), end, links);
  EXPECT_EQ(links.size(), chip.keys().size());
  for (const knobs& k : {with([](knobs& k) { k.interval_stack_depth = 1; }),
                         with([](knobs& k) { k.hurry_threshold = 200; })}) {
    const ErrorChain chain(demo(), k, PictureReference::Geometry);
    ErrorChain::Links shared(links.size());
    for (std::size_t i = 0; i < links.size(); ++i)
      if (chain.keys()[i] == chip.keys()[i]) shared[i] = links[i];
    EXPECT_EQ(chain.by_cause(Frame, TlmPictures(demo(), Frame, k).picture(k), end, shared),
              errors_by_cause(demo(), Frame, k, PictureReference::Geometry));
  }
}

}  // namespace
}  // namespace racebeam
