// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace racebeam {

/// A point of a search: of each knob of the sweep file, which of its values.
using ValueIndices = std::vector<std::size_t>;

}  // namespace racebeam
