// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/signoff/mutant_totals.h"
#include "tb/signoff/shared_work.h"

namespace racebeam {

MutantSizes mutant_sizes(const MutantStreams& streams, const RecordedStream& random,
                         const std::map<int, MutantFate>& fates, int jobs,
                         const std::function<void(std::size_t done, std::size_t of)>& told) {
  const PortTraffic traffic = whole_traffic(random);
  std::vector<const MutantFate*> found;
  for (const auto& [number, fate] : fates)
    if (fate.state == MutantFate::Found && fate.stream == random.name && !fate.port.empty())
      found.push_back(&fate);
  MutantSizes sizes;
  std::size_t done = 0;
  share_work(
      jobs,
      [&](int share, const SayLine& say) {
        for (std::size_t n = static_cast<std::size_t>(share); n < found.size();
             n += static_cast<std::size_t>(jobs)) {
          if (interrupted()) throw Interrupted();
          const auto small =
              streams.smallest(found[n]->number, input_rows(traffic, found[n]->clock));
          say(small ? fmt::format("{} {}", small->stream.clocks() - 1, small->stream.moving())
                    : "none");
        }
      },
      [&](const std::string& line) {
        told(++done, found.size());
        std::istringstream words(line);
        std::uint64_t clocks = 0, moving = 0;
        if (words >> clocks >> moving) {
          sizes.clocks.push_back(clocks);
          sizes.moving.push_back(moving);
        } else {
          ++sizes.left;
        }
      });
  std::sort(sizes.clocks.begin(), sizes.clocks.end());
  std::sort(sizes.moving.begin(), sizes.moving.end());
  return sizes;
}

std::string text_of(const MutantSizes& sizes) {
  return fmt::format("median {} clocks and {} moving inputs, p99 {} and {}",
                     percentile(sizes.clocks, 50), percentile(sizes.moving, 50),
                     percentile(sizes.clocks, 99), percentile(sizes.moving, 99));
}

nlohmann::ordered_json to_json(const MutantSizes& sizes) {
  const auto spread = [](const std::vector<std::uint64_t>& sorted) {
    return nlohmann::ordered_json{{"median", percentile(sorted, 50)},
                                  {"p90", percentile(sorted, 90)},
                                  {"p99", percentile(sorted, 99)},
                                  {"most", percentile(sorted, 100)}};
  };
  return {{"mutants", sizes.clocks.size()}, {"not_shrunk", sizes.left},
          {"clocks", spread(sizes.clocks)}, {"clocks_within", found_within(sizes.clocks)},
          {"moving", spread(sizes.moving)}, {"moving_within", found_within(sizes.moving)}};
}

std::uint64_t percentile(const std::vector<std::uint64_t>& sorted, int percent) {
  if (sorted.empty()) return 0;
  const auto rank =
      static_cast<std::size_t>(std::ceil(static_cast<double>(sorted.size()) * percent / 100));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

}  // namespace racebeam
