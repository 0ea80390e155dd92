// SphereHands: what is around the wired sphere tracer: its CPU, and the hands at switches and keys.
//
// A picture begins with a frame of the raster, as SphereBench says: the store is made black, the
// CPU sends its words, the tracer draws, the rest of the words goes into the store.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sc/sphere/sphere_chip.h"
#include "tb/bench/surroundings.h"
#include "tb/bench/wired_bench.h"
#include "tb/host/sphere_program.h"
#include "tb/host/sphere_words.h"

namespace racebeam {

class SphereHands final : public Surroundings {
 public:
  /// `chip` is connected to a bench and stands before its first clock; what it is and `program`
  /// outlive the hands.
  SphereHands(sphere_chip& chip, const SphereProgram& program, const sphere_knobs& k);

  void seek(int picture) override;
  void clock() override;
  bool busy() const override { return busy_; }
  void hold_reset() override;
  void rest(int frames) override { rest_ = frames; }
  int pictures() const override { return pictures_; }

  /// The picture that was done last: the frame store by address, and what was counted.
  const std::vector<std::uint64_t>& memory() const { return memory_; }
  const sphere_counters& counters() const { return counters_; }

 private:
  void begin();
  void send();
  void finish();

  sphere_chip& chip_;
  const SphereProgram& program_;
  const sphere_knobs knobs_;
  const int frame_clocks_;

  SphereMotion motion_;
  int next_ = 0;         // picture to be begun
  int frame_clock_ = 0;  // that is being simulated
  std::optional<SphereWords> words_;
  bool begun_ = false, busy_ = false, held_ = false;
  bool started_ = false;  // the tracer has left HOST
  int pictures_ = 0;
  int rest_ = 0, resting_ = 0;  // frames after a picture; of them still to come
  std::vector<std::uint64_t> memory_;
  sphere_counters counters_;
};

/// BenchKind::around.
std::unique_ptr<Surroundings> make_sphere_hands(wired_chip& chip,
                                                const WiredBench::Setting& setting);

}  // namespace racebeam
