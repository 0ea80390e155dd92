// ComparedCell: a scene by an engine, measured: its figures with all that they come from.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/judge/hit_maps.h"
#include "tb/report/compare_metrics.h"

namespace racebeam {

struct ComparedCell {
  std::string engine, scene;
  int first = 0;      ///< picture
  std::string knobs;  ///< "cores=1", or "default"
  Numbers numbers;    ///< counters, knobs, and compare_numbers(); no quantities
  struct Quantity {
    std::string name, formula;
    std::optional<double> value;
  };
  std::vector<Quantity> quantities;
  std::vector<std::optional<double>> metrics;  ///< by compare_metrics()

  /// The last picture.
  VgaFrame picture, ideal;  ///< ideal of width 0: there is none
  HitMap hits, ideal_hits;

  std::string bytes() const;
  static ComparedCell of_bytes(const std::string& bytes);
};

/// Draws `pictures` of a show, from picture `first` on: one per process, as any ChipBench.
ComparedCell measure_cell(const Show& show, const knob_values& k, int first, int pictures);

}  // namespace racebeam
