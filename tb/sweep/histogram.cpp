// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/histogram.h"

#include <endian.h>

#include <algorithm>
#include <cstring>

namespace racebeam {

void Histogram::add(std::int64_t more_frames, const std::vector<std::int64_t>& more) {
  frames += more_frames;
  bins.resize(std::max(bins.size(), more.size()));
  for (std::size_t i = 0; i < more.size(); ++i) bins[i] += more[i];
}

std::string bytes_of(const std::vector<std::int64_t>& bins) {
  std::string bytes;
  for (const std::int64_t bin : bins) {
    const std::uint64_t little = htole64(static_cast<std::uint64_t>(bin));
    bytes.append(reinterpret_cast<const char*>(&little), sizeof little);
  }
  return bytes;
}

std::vector<std::int64_t> bins_of(const std::string& bytes) {
  std::vector<std::int64_t> bins(bytes.size() / sizeof(std::int64_t));
  for (std::size_t i = 0; i < bins.size(); ++i) {
    std::uint64_t little;
    std::memcpy(&little, bytes.data() + i * sizeof little, sizeof little);
    bins[i] = static_cast<std::int64_t>(le64toh(little));
  }
  return bins;
}

}  // namespace racebeam
