// The `tlm` level of the sphere tracer on the bench: its cores in one loop, and a CPU that is plain
// code.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/sphere/sphere_core.h"
#include "tb/bench/benches.h"
#include "tb/host/sphere_program.h"

namespace racebeam {

class SphereTlmBench final : public ChipBench {
 public:
  /// The scene outlives it.
  SphereTlmBench(const WiredBench::Setting& setting, const BenchWishes& wishes);

  void seek(int picture) override;
  Frame render() override;
  std::uint64_t clocks() const override {
    return static_cast<std::uint64_t>(core_.store().clock());
  }
  const SoundMonitor* sound() const override { return nullptr; }

  /// The frame store with all words of the picture that was rendered last, by address.
  std::vector<std::uint64_t> words() const { return core_.picture(); }

  /// As sphere_core has it.
  void note_pixels(std::vector<std::int64_t>* begins) { core_.note_pixels(begins); }

 private:
  const SphereProgram& program_;
  const sphere_knobs knobs_;
  const BenchWishes wishes_;
  const int pictures_;  // of the show
  sphere_core core_;
  SphereMotion motion_;
  int next_ = 0;
};

/// BenchKind::pixels.
PixelClocks sphere_pixels(const WiredBench::Setting& setting, int picture);

}  // namespace racebeam
