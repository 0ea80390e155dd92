// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/load_bar.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

void LoadBar::add(const block_counters& counters) {
  std::vector<double> shares;
  for (int core = 0; core < knobs_.cores; ++core)
    shares.push_back(static_cast<double>(counters.busy_by_core[static_cast<std::size_t>(core)]) /
                     static_cast<double>(std::max<std::uint64_t>(counters.clocks, 1)));
  shares_.push_back(std::move(shares));
  if (shares_.size() > Pictures) shares_.pop_front();
}

int LoadBar::brightness(int core) const {
  double sum = 0;
  for (const auto& shares : shares_) sum += shares[static_cast<std::size_t>(core)];
  const double mean = shares_.empty() ? 0 : sum / static_cast<double>(shares_.size());
  return static_cast<int>(std::lround(255 * std::min(mean, 1.0)));
}

void LoadBar::draw(PackedPicture& picture) const {
  for (int core = 0; core < knobs_.cores; ++core)
    for (int n = 0; n < Side * Side; ++n) {
      const int x = Side * core + n % Side, y = picture.height - Side + n / Side;
      const auto at = static_cast<std::size_t>(picture.colour_bytes() * (y * picture.width + x));
      for (std::size_t channel = 0; channel < 3; ++channel)
        picture.colours[at + channel] = static_cast<std::uint8_t>(brightness(core));
    }
}

}  // namespace racebeam
