// SphereHands: what is around the wired sphere tracer: its CPU, and the hands at switches and keys.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "sc/sphere/sphere_chip.h"
#include "tb/bench/picture_hands.h"
#include "tb/bench/wired_bench.h"
#include "tb/host/sphere_program.h"
#include "tb/host/sphere_words.h"

namespace racebeam {

class SphereHands final : public PictureHands {
 public:
  /// As PictureHands; `program` outlives it, too.
  SphereHands(sphere_chip& chip, const SphereProgram& program, const sphere_knobs& k);

  void stop() override;

  /// What was counted of the picture that was done last.
  const sphere_counters& counters() const { return counters_; }

 private:
  void go_to(int picture) override;
  void begin(int picture) override;
  bool send() override;
  void prepare(int picture) override;
  void end() override { counters_ = chip_.collector().last(); }
  void put_words();

  sphere_chip& chip_;
  const SphereProgram& program_;
  const sphere_knobs knobs_;

  SphereMotion motion_;
  std::optional<SphereWords> words_;
  bool started_ = false;  // the tracer has left HOST
  sphere_counters counters_;
};

/// BenchKind::around.
std::unique_ptr<Surroundings> make_sphere_hands(wired_chip& chip,
                                                const WiredBench::Setting& setting);

}  // namespace racebeam
