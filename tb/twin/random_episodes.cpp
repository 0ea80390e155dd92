// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/random_episodes.h"

#include <filesystem>

#include "sc/beam/sequencer.h"
#include "tb/base/project_folder.h"
#include "tb/scene/engines.h"
#include "tb/twin/port_stream.h"
#include "tb/twin/twins.h"

namespace racebeam {

std::string known_streams(const UnitUnderTest& dut) {
  return project_folder() + "/tb/twin/streams/" + engine_of(dut.k).name + "/" + dut.unit +
         ".stream";
}

std::shared_ptr<RandomTraffic> random_traffic(const UnitUnderTest& dut, UnitBench& bench,
                                              unsigned seed) {
  const engine& built = engine_of(dut.k);
  const LegalInputs legal = twins_of(built).inputs(dut.k, dut.scene, dut.unit);
  auto traffic = std::make_shared<RandomTraffic>(bench, legal, seed);
  const std::string known = known_streams(dut);
  if (dut.k == built.standard(nullptr) && std::filesystem::exists(known))
    traffic->begin_with(read_episodes(known, stream_of(traffic_of(dut.unit, bench), legal)));
  return traffic;
}

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
