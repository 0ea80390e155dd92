// The pictures of a report: which of those that a sweep has kept go into the page.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tb/report/reported_sweep.h"

namespace racebeam {

struct ReportPicture {
  std::size_t point = 0, scene = 0;
  int frame = 0;
  std::string why;     ///< "worst", or ""
  std::string base64;  ///< of the PNG file
};

struct ReportPictures {
  std::vector<ReportPicture> taken;  ///< by point, in their order
  int left_out = 0;                  ///< for want of room
};

/// Those of the base and the front, then the others', as long as they take `room` bytes at most.
ReportPictures report_pictures(const ReportedSweep& sweep, const SweepFolder& folder,
                               std::size_t room);

/// As data URLs have it.
std::string base64(const std::string& bytes);

}  // namespace racebeam
