// What is counted of a frame store while a picture is drawn into it. An engine's counters contain
// these.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/store/store_knobs.h"

namespace racebeam {

struct store_counters {
  std::uint64_t words = 0;          ///< into the write buffer
  std::uint64_t buffer_stalls = 0;  ///< clocks in which a word waited, since it was full
  std::uint64_t buffer_lost = 0;    ///< words
  std::uint64_t store_reads = 0, store_writes = 0;
  std::array<std::uint64_t, MaxWriteBuffer + 1> buffer_fill{};  ///< clocks with so many words
};

}  // namespace racebeam
