// The figures that claims are about, by name, and where each comes from.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace racebeam {

enum class ClaimSource {
  Arithmetic,  ///< all inputs of a core's function, without frames: claim_arithmetic.h
  Frames,      ///< counted in frames of a chip: tb/sweep/figures.h
  Golden,      ///< found with golden tracers and pictures of frames: claim_golden.h
  Silicon      ///< "cells", "flip_flops.ray_stepper": by yosys, of the chip or of a unit;
               ///< "longest_path"
};

/// Nothing: there is no figure of this name.
std::optional<ClaimSource> claim_source(const std::string& figure);

/// For advice.
std::vector<std::string> claim_figure_names();

/// "flip_flops.ray_stepper": what is counted, and the unit, "" for the chip without sound.
struct SiliconFigure {
  enum What { FlipFlops, Cells, LongestPath } what;
  std::string unit;
};
std::optional<SiliconFigure> silicon_figure(const std::string& figure);

}  // namespace racebeam
