// Sweeps as texts in tests, with a few figures and one scene beside the demo.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <ostream>
#include <string>
#include <vector>

#include "sc/beam/knobs.h"
#include "tb/sweep/sweep_points.h"
#include "tb/sweep/sweep_reader.h"

namespace racebeam {

inline SweepNames test_names() {
  return {{{"picture_error", "%"},
           {"starved", "%"},
           {"busy", "clocks a line"},
           {"busy.max", "clocks", false},
           {"error.give_up", "%", true, "causes"},
           {"cells", "cells", false, "silicon"},
           {"flip_flops", "bits", false, "silicon"}},
          {"demo", "chip/tunnel", "house"},
          [](const std::string& name) { return name == "demo" || name == "house"; }};
}

/// "f:LINE:COLUMN: what" and "  help: ..." of each fault; empty if there is none.
inline std::string sweep_faults(const std::string& text) {
  return read_sweep(text, "f", test_names()).faults.text("f");
}

struct BadSweep {
  const char* name;
  std::string text;
  std::string fault;  ///< "LINE:COLUMN: what"
  std::string help;
};

inline void PrintTo(const BadSweep& bad, std::ostream* out) { *out << bad.text; }

/// It has this fault and no other.
inline void expect_fault(const BadSweep& bad) {
  const std::string faults = sweep_faults(bad.text);
  EXPECT_THAT(faults,
              testing::AllOf(testing::StartsWith("f:" + bad.fault),
                             testing::HasSubstr("\n  help: "), testing::HasSubstr(bad.help)));
  EXPECT_EQ(faults.find("\nf:"), std::string::npos) << faults;
}

/// A sweep that has no faults.
inline SweepFile sweep(const std::string& text, const std::vector<std::string>& narrowed = {}) {
  const SweepResult result = read_sweep(text, "f", test_names(), narrowed);
  EXPECT_EQ(result.faults.text("f"), "");
  return result.file;
}

/// "name knob=value ...", with the knobs that are not the chip's.
inline std::string told(const SweepPoint& point) {
  std::string text = point.name;
  for (const knob_info& row : knob_table())
    if (const int value = point.k.of(row.name); value != knobs{}.*row.member)
      text += " " + std::string(row.name) + "=" + row.text(value);
  return text;
}

inline std::vector<std::string> told(const SweepPoints& points) {
  std::vector<std::string> all;
  for (const SweepPoint& point : points.points) all.push_back(told(point));
  return all;
}

}  // namespace racebeam
