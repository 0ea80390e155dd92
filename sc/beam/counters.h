// The tables of what is counted in a frame: the schema of stats.json, and the order of the
// registers of the tlm level.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/beam/frame_stats.h"

namespace racebeam {

struct counter_row {
  counter_info info;
  std::uint64_t frame_stats::*member;  ///< nullptr: decisions(), a sum of others and no register
};
const std::vector<counter_row>& counter_table();

struct histogram_row {
  histogram_info info;
  std::array<std::uint64_t, 65> frame_stats::*member;
};
const std::vector<histogram_row>& histogram_table();

struct line_row {
  line_info info;
  std::vector<int> frame_stats::*member;
};
const std::vector<line_row>& line_table();

/// The members that are registers, in their order.
std::vector<std::uint64_t frame_stats::*> counter_registers();

/// By the tables.
frame_counts counted(const frame_stats& stats);

}  // namespace racebeam
