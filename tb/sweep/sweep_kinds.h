// What sweeps do with each engine, in a row each.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "sc/base/silicon.h"
#include "tb/sweep/frame_judge.h"
#include "tb/sweep/sweep_reader.h"

namespace racebeam {

struct SweepKind {
  const racebeam::engine& engine;
  EngineMeasures measures;
  std::vector<const char*> errors;   ///< columns of a frame that has been judged
  std::vector<const char*> shown;    ///< figures of a table, beside those of goals
  std::array<const char*, 2> worst;  ///< the columns in which guard frames have the largest values
  std::vector<const char*> outside;  ///< knobs that are no silicon: pins, the board, the host
  silicon (*made_of)(const knob_values& k, const scene_tables* scene);
  std::unique_ptr<FrameJudge> (*judge)(const Show& show, const Block& block);
};

const std::vector<SweepKind>& sweep_kinds();

/// The row of an engine. Throws std::out_of_range.
const SweepKind& sweep_kind(const engine& built);

/// Whose model has this hash in this program; nullptr: nobody's.
const engine* engine_of_model(const std::string& hash);

}  // namespace racebeam
