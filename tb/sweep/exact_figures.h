// Figures of designs, such as cells, beside the frames of a store: what the last run gave them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/sweep/store.h"

namespace racebeam {

struct ExactFigure {
  std::int64_t point = 0;  ///< id of the store
  std::string figure;
  double value = 0;
};

/// In the place of those before, of a model.
void keep_exact(Store& store, std::int64_t model, const std::vector<ExactFigure>& figures);
std::vector<ExactFigure> kept_exact(const Store& store, std::int64_t model);

}  // namespace racebeam
