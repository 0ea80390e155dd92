// What claims need of a frame beside its counters: the work of the golden tracers, and what moves.
//
// It takes a tenth of a second a frame and knob setting, so it is done in workers and kept, by
// sets: who asks for one column of a set gets all of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sc/beam/knobs.h"
#include "tb/show/show.h"

namespace racebeam {

struct GoldenSet {
  const char* name;  ///< part of the key of what is kept: to be changed with what `find` does
  std::vector<std::string> columns;
  std::vector<std::int64_t> (*find)(const Show& show, int frame, const knobs& k);
};

const std::vector<GoldenSet>& golden_sets();

/// Where a figure stands; nullptr: there is none of that name.
struct GoldenFigure {
  const GoldenSet* set;
  std::size_t column;
};
const GoldenFigure* golden_figure(const std::string& name);

/// Frames of a scene that a worker is asked for.
struct GoldenRequest {
  std::string scene;
  std::string set;
  knob_values k;
  std::vector<int> frames;
};
std::string golden_request(const GoldenRequest& request);
/// What a worker does with it: see ForkServer. A line for each frame, in their order, and "done".
void answer_golden(const std::string& request, int file);
/// By frame. Throws std::runtime_error with what the worker has said, if it did not get through.
std::map<int, std::vector<std::int64_t>> golden_answer(const std::string& lines);

}  // namespace racebeam
