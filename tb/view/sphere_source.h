// SphereSource: the sphere tracer, its board and its CPU as a source of pictures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sc/sphere/sphere_core.h"
#include "tb/host/sphere_program.h"
#include "tb/view/sources.h"
#include "tb/view/store_source.h"

namespace racebeam {

class SphereSource : public StoreSource {
 public:
  /// Stands before picture 0 of `pictures`. The program outlives it.
  SphereSource(const SphereProgram& program, const sphere_knobs& k, int pictures);

  /// Switches and keys, then the counters.
  Rows rows() const override;
  std::optional<BoardPins> board() const override { return pins_; }
  void press(BoardPins pins) override;
  bool as_in_scene() const override { return !touched_; }

 private:
  void restart() override;
  std::vector<std::uint64_t> draw() override;
  void skip() override;
  int picture_rows() const override { return core_->rows(); }
  std::uint64_t picture_clocks() const override;
  frame_counts counts() const override { return counted(core_->counters()); }
  const std::vector<counter_info>& counter_infos() const override;
  sphere_board board_now() const;
  void before_picture();

  const SphereProgram& program_;
  const sphere_knobs knobs_;
  std::optional<sphere_core> core_;
  std::optional<SphereMotion> motion_;
  BoardPins pins_;
  bool touched_ = false;
};

/// The row of sources().
SourceKind sphere_sources();

}  // namespace racebeam
