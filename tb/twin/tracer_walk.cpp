// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/tracer_walk.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>

#include "sc/base/fixed_point.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"

namespace racebeam {

namespace {

constexpr int Episode = 150;      // clocks at most
constexpr int DistanceUnit = 16;  // of a root that is the distance of the light

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

}  // namespace

TracerWalk::TracerWalk(UnitBench& bench, const knob_values& k, unsigned seed)
    : bench_(bench), min_weight_(sphere_knobs(k).min_weight), random_(seed) {
  for (UnitBench::Pin* pin : bench.pins()) {
    if (!pin->input || pin->name == "rst_ni") continue;
    const bool mode = is_one_of(pin->name, {"max_reflections_i", "alias_i", "narrow_i", "planes_i",
                                            "sphere_last_i", "plane_last_i", "plane_empty_i"});
    (mode ? modes_ : pin->bits == 1 ? flags_ : numbers_).push_back(pin);
  }
}

void TracerWalk::next() {
  if (!begun_) return begin_picture();
  if (drawn_ < Pictures) return go_through_pictures();
  if (left_-- == 0) begin_episode();
  for (UnitBench::Pin* pin : flags_) pin->drive(!one_in(4));
  if (kind_ == Kind::Mirrors) return bench_["is_light_i"].drive(0);
  if (kind_ == Kind::Ties) return drive_ties();
  for (UnitBench::Pin* pin : numbers_)
    if (!one_in(3)) pin->drive(number(pin->bits));
  if (one_in(2)) bench_["root_i"].drive(value_ / DistanceUnit);
  if (reach_ > 0) drive_limits();
}

// Planes are met before or behind their limits, or right there, whatever these are. Of the eye in
// the origin that is so in whole numbers.
void TracerWalk::drive_limits() {
  const bool whole = one_in(2);
  bench_["limited_i"].drive(1);
  for (const char axis : {'x', 'y', 'z'}) {
    const auto pin = [&](const char* name) -> UnitBench::Pin& {
      return bench_[std::string(name) + axis + "_i"];
    };
    const std::uint64_t limit = random_() % static_cast<unsigned>(reach_);
    pin("limit_").drive(limit);
    const std::uint64_t most = std::uint64_t(one_in(2) ? limit + 1 : reach_) << SphereFraction;
    const std::uint64_t way = whole && one_in(2) ? limit << SphereFraction : random_() % most;
    pin("product_").drive(raw_bits(one_in(2) ? way : -way, SphereBits));
    if (whole) pin("origin_").drive(0);
  }
  bench_["quotient_x_i"].drive(random_() % (1u << (SphereBits - 1)));
}

// The eye is in a sphere, and nobody has to wait.
void TracerWalk::begin_picture() {
  for (const auto* pins : {&flags_, &modes_, &numbers_})
    for (UnitBench::Pin* pin : *pins) pin->drive(0);
  for (const char* on : {"loaded_i", "root_done_i", "divider_done_i", "word_ready_i", "radius2_i"})
    bench_[on].drive(1);
  begun_ = true;
}

// Two pictures. The first line of one has 512 columns; the second one changes to 320 behind those,
// so that it goes on until the column is 0 again. The other one is narrow but in the last row of a
// narrow picture, so that this does not end it, and in its own last one. Pixels of the first and
// the last column have several rays.
void TracerWalk::go_through_pictures() {
  constexpr std::uint64_t LastNarrowRow = 239, LastRow = 479;
  const std::uint64_t x = bench_["x_o"].value(), y = bench_["y_o"].value();
  bench_["rst_ni"].drive(1);
  narrow_ = narrow_ || (y == 1 && x > 400);
  const bool wide = drawn_ == 0 ? !narrow_ : y == LastNarrowRow || y == LastRow;
  bench_["narrow_i"].drive(!wide);
  bench_["alias_i"].drive(x == 0 || x == 319 ? y & 3 : 0);
  if (bench_["picture_done_o"].value()) ++drawn_;
}

// Of those that have no mirrors every other one has planes and few spheres before them.
void TracerWalk::begin_episode() {
  left_ = 1 + static_cast<int>(random_() % Episode);
  for (UnitBench::Pin* pin : modes_)
    pin->drive(raw_bits(random_() >> (one_in(2) ? 30 : 0), pin->bits));
  reach_ = 0;
  kind_ = one_in(4) ? Kind::Mirrors : one_in(4) ? Kind::Ties : Kind::Any;
  if (kind_ == Kind::Mirrors) return begin_mirrors();
  if (kind_ == Kind::Ties) return begin_ties();
  if (one_in(2)) {
    bench_["planes_i"].drive(1);
    bench_["plane_empty_i"].drive(0);
    bench_["sphere_last_i"].drive(0);
    if (one_in(2)) reach_ = 2 << random_() % UnitBits;
  }
  const std::uint64_t any = random_() & low_bits(SphereBits);
  const std::uint64_t numbers[] = {std::uint64_t{1 + random_() % 8} << SphereFraction, NearestPlane,
                                   static_cast<std::uint64_t>(min_weight_), any,
                                   any >> random_() % SphereBits};
  value_ = numbers[one_in(4) ? 0 : random_() % std::size(numbers)];
}

// All rays meet a sphere without a size, which is a mirror, so that there are three reflections.
void TracerWalk::begin_mirrors() {
  left_ = 2 * Episode;
  for (const auto* pins : {&modes_, &numbers_})
    for (UnitBench::Pin* pin : *pins) pin->drive(0);
  for (const char* one : {"sum_i", "square_i"}) bench_[one].drive(1);
  for (const char* most : {"max_reflections_i", "weight_i"})
    bench_[most].drive(low_bits(bench_[most].bits));
}

// Rays meet all spheres, or pass them and meet planes, at one distance, which is the light's, too.
// Planes are seen from where the sum is negative.
void TracerWalk::begin_ties() {
  passes_ = one_in(2);
  bench_["planes_i"].drive(passes_);
  bench_["plane_empty_i"].drive(0);
  if (passes_) bench_["sphere_last_i"].drive(0);
  value_ = random_() & low_bits(SphereBits - 1);
  for (UnitBench::Pin* pin : numbers_) pin->drive(raw_bits(random_(), pin->bits));
  for (const char* off : {"radius2_i", "limited_i"}) bench_[off].drive(0);
  bench_["square_i"].drive(passes_ ? 0 : std::uint64_t{1} << (SphereSumBits - 2));
  bench_["root_i"].drive(value_ / DistanceUnit);
}

// The distance is the one of the episode, or one more or less. Colours tell what was met.
void TracerWalk::drive_ties() {
  for (const char* off : {"limited_i", "is_light_i"}) bench_[off].drive(0);
  const auto near = [&] { return value_ + random_() % 3 - 1; };
  bench_["quotient_x_i"].drive(raw_bits(near(), SphereBits));
  const std::uint64_t sum = near() << SphereFraction | (random_() & low_bits(SphereFraction));
  bench_["sum_i"].drive(raw_bits(passes_ && one_in(2) ? -sum : sum, SphereSumBits));
  for (const char* colour : {"sphere_red_i", "plane_red_i"})
    bench_[colour].drive(raw_bits(random_(), SphereColourBits));
}

// That of the episode, or beside it, negative, a sixteenth, or 0; sums have it where it becomes a
// number, or a square.
std::uint64_t TracerWalk::number(int bits) {
  std::uint64_t value = one_in(3) ? 0 : value_;
  switch (random_() % 8) {
    case 0: ++value; break;
    case 1: --value; break;
    case 2:
    case 3: value = -value; break;
    case 4: value >>= 4; break;
    default: break;
  }
  if (bits == SphereSumBits)
    return raw_bits(value << (one_in(2) ? SphereFraction : SphereBits), bits);
  if (bits == UnitBits && one_in(2)) value >>= SphereFraction;
  return raw_bits(value, bits);
}

}  // namespace racebeam
