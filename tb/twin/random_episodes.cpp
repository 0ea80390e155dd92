// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/random_episodes.h"

#include "sc/beam/sequencer.h"

namespace racebeam {

void seek_at_episodes(RandomTraffic& traffic, sc_core::sc_module& model, int frames,
                      const std::function<void(int frame)>& beside) {
  auto* const counter = dynamic_cast<sequencer_pins*>(&model);
  if (!counter) return;
  traffic.at_episodes([counter, count = static_cast<unsigned>(frames), beside](unsigned random) {
    const int frame = static_cast<int>(random % 4 == 0 ? count - 1 : random / 4 % count);
    counter->deposit(frame);
    beside(frame);
  });
}

}  // namespace racebeam
