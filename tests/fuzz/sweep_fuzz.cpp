// libFuzzer target: no text makes the sweep reader crash or hang, and the points of a sweep without
// faults are what its file asks for.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "sc/beam/knobs.h"
#include "tb/sweep/sweep_points.h"
#include "tb/sweep/sweep_reader.h"
#include "tests/fuzz/stand_in_engines.h"

namespace {

racebeam::SweepNames names() {
  return {{{"picture_error", "%"},
           {"busy", "clocks a line"},
           {"error.give_up", "%", true, "causes"},
           {"cells", "cells", false, "silicon"}},
          {"demo", "house"},
          [](const std::string& name) { return name == "demo" || name == "house"; }};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  const SweepResult result = read_sweep(text_of(data, size), "fuzz", names());
  (void)result.faults.text("fuzz");
  (void)result.faults.warnings("fuzz");
  const SweepFile& file = result.file;
  // Many points are slow under sanitizers.
  if (!result.faults.none() || grid_points(file) > 1000 || file.search.points > 1000) return 0;
  const SweepPoints points = sweep_points(file);
  check(points.points.front().name == file.base.name);
  std::set<std::string> texts, names_seen;
  for (const SweepPoint& point : points.points) {
    check(texts.insert(point_text(point.k)).second);
    check(names_seen.insert(point.name).second);
    for (const knob_info& row : knob_table())
      check(point.k.of(row.name) >= row.min && point.k.of(row.name) <= row.max);
  }
  check(file.search.method == SearchMethod::OneByOne || points.of_search <= grid_points(file));
  return 0;
}
