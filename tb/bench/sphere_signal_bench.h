// The `signal` level of the sphere tracer on the bench: a WiredBench with its CPU and hands, whose
// pictures are those of the frame store.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tb/bench/benches.h"
#include "tb/bench/sphere_hands.h"

namespace racebeam {

class SphereSignalBench final : public WiredBench {
 public:
  /// The scene outlives it. Throws RtlError.
  SphereSignalBench(const Setting& setting, const BenchWishes& wishes);

  void seek(int picture) override;
  /// Throws as WiredBench's.
  Frame render() override;

  /// The frame store with all words of the picture that was rendered last, by address.
  const std::vector<std::uint64_t>& words() const { return hands().memory(); }

 private:
  const SphereHands& hands() const { return static_cast<const SphereHands&>(*around()); }

  const SphereProgram& program_;
  const sphere_knobs knobs_;
  const BenchWishes wishes_;
  const int pictures_;  // of the show
  int next_ = 0;
};

}  // namespace racebeam
