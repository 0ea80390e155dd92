// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/shader_walk.h"

#include <iterator>

#include "sc/base/fixed_point.h"
#include "sc/sphere/codes.h"

namespace racebeam {

namespace {

constexpr int MostHits = 4;  // of a ray

}  // namespace

void ShaderWalk::next() {
  bench_["rst_ni"].drive(begun_);
  if (sub_ == subs_) return begin_pixel();
  if (adds_) {
    bench_["op_i"].drive(ShadeAdd);
    bench_["reflect_i"].drive(high_or_any(UnitBits));
    adds_ = false;
  } else if (hits_ > 0) {
    hit();
  } else {
    bench_["op_i"].drive(ShadeStore);
    bench_["sub_i"].drive(static_cast<std::uint64_t>(sub_++));
    hits_ = static_cast<int>(random_() % (MostHits + 1));
  }
}

// Of one ray, of five, or of nine.
void ShaderWalk::begin_pixel() {
  begun_ = true;
  const std::uint64_t alias = random_() % 4;
  bench_["alias_i"].drive(alias);
  bench_["op_i"].drive(ShadeStart);
  bench_["sub_i"].drive(0);
  sub_ = 0;
  subs_ = alias >= 2 ? 9 : alias == 1 ? 5 : 1;
  hits_ = static_cast<int>(random_() % (MostHits + 1));
}

void ShaderWalk::hit() {
  constexpr int Ops[] = {ShadeLit, ShadeLit, ShadeLit, ShadeHalf, ShadePlain, ShadeLight};
  bench_["op_i"].drive(static_cast<std::uint64_t>(Ops[random_() % std::size(Ops)]));
  for (const char* base : {"base_red_i", "base_green_i", "base_blue_i"})
    bench_[base].drive(high_or_any(SphereColourBits));
  bench_["dark_i"].drive(one_in(4));
  bench_["direct_i"].drive(one_in(2));
  bench_["fraction_i"].drive(high_or_any(UnitBits));
  bench_["sub_i"].drive(static_cast<std::uint64_t>(sub_));
  adds_ = true;
  --hits_;
}

// All bits, or any.
std::uint64_t ShaderWalk::high_or_any(int bits) {
  return raw_bits(one_in(3) ? ~std::uint64_t{0} : random_(), bits);
}

}  // namespace racebeam
