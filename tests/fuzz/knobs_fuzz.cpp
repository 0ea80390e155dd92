// libFuzzer target: no text makes --set crash; a knob that it sets is within its range, and the
// text of all knobs sets them again.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "sc/beam/knobs.h"
#include "sc/block/knobs.h"
#include "sc/sphere/knobs.h"
#include "sc/voxel/knobs.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/scene/engines.h"
#include "tb/show/knobs_json.h"
#include "tb/show/set_knob.h"
#include "tests/fuzz/stand_in_engines.h"

void racebeam::tell(std::string_view) {}

const std::vector<const racebeam::engine*>& racebeam::engines() {
  static const engine beam = stand_in_engine("beam", knob_rows()),
                      sphere = stand_in_engine("sphere", sphere_knob_rows()),
                      block = stand_in_engine("block", block_knob_rows()),
                      voxel = stand_in_engine("voxel", voxel_knob_rows());
  static const std::vector<const engine*> table = {&beam, &sphere, &block, &voxel};
  return table;
}

namespace {

using namespace racebeam;

/// As it was built.
knob_values standard(const engine& of) {
  std::vector<int> values;
  for (const knob_row& row : of.knobs) values.push_back(row.standard);
  return {of.knobs, values};
}

void check_values(const engine& of, const knob_values& k) {
  for (std::size_t n = 0; n < k.rows().size(); ++n)
    check(k[n] >= k.rows()[n].min && k[n] <= k.rows()[n].max);
  (void)knobs_json(k).dump();
  const std::string text = knobs_text(k);
  knob_values again = standard(of);
  if (text != "default")
    for (std::size_t at = 0, end; at < text.size(); at = end + 2) {
      end = std::min(text.find(", ", at), text.size());
      set_knob(again, text.substr(at, end - at));
    }
  check(again == k);
}

}  // namespace

// Each line is a --set, of the engine that the length chooses.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const engine& of = *engines()[size % engines().size()];
  knob_values k = standard(of);
  bool changed = false;
  std::istringstream lines{std::string(text_of(data, size))};
  for (std::string line; std::getline(lines, line);) try {
      set_knob(k, line);
      changed = true;
    } catch (const UsageError&) {
    }
  if (changed) check_values(of, k);
  return 0;
}
