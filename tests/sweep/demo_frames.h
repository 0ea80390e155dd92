// True figures of the demo, for tests of statistics: every third frame without a ray pattern, as
// `racebeam render demo --stats` counts them; columns that end in 64: with hurry_threshold=64.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "tb/sweep/interval.h"

namespace racebeam {

struct DemoFigures {
  std::vector<std::string> names;
  std::vector<std::vector<double>> figures;  ///< by name, of each frame
};

inline DemoFigures demo_frames() {
  std::ifstream file(RACEBEAM_SOURCE_DIR "/tests/sweep/demo_frames.csv");
  DemoFigures demo;
  std::string line, field;
  std::getline(file, line);
  std::istringstream head(line);
  while (std::getline(head, field, ',')) demo.names.push_back(field);
  demo.figures.resize(demo.names.size());
  while (std::getline(file, line)) {
    std::istringstream row(line);
    for (std::vector<double>& figure : demo.figures) {
      std::getline(row, field, ',');
      figure.push_back(std::stod(field));
    }
  }
  return demo;
}

inline double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The first `n` frames of an order of indices.
inline Stratum taken(const std::vector<double>& figure, const std::vector<int>& order, int n) {
  Stratum stratum;
  stratum.population = static_cast<int>(figure.size());
  stratum.frames.assign(order.begin(), order.begin() + n);
  std::sort(stratum.frames.begin(), stratum.frames.end());
  for (const int frame : stratum.frames)
    stratum.values.push_back(figure[static_cast<std::size_t>(frame)]);
  return stratum;
}

}  // namespace racebeam
