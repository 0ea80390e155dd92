// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/report_silicon.h"

#include <cstdlib>

#include "tb/base/errors.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/csv_rows.h"
#include "tb/sweep/silicon.h"

namespace racebeam {

namespace {

/// Of one point; empty if not all are known.
std::vector<ReportedUnit> units_of(const Silicon& silicon, const Store& store,
                                   const knob_values& k) try {
  std::vector<ReportedUnit> units;
  for (const UnitParameters& unit : silicon.units_of(k)) {
    const std::optional<UnitSilicon> found = store.units.find(unit.hash);
    if (!found) return {};
    units.push_back({unit.unit, found->cells, found->flip_flops});
  }
  return units;
} catch (const NoSilicon&) {
  return {};
}

}  // namespace

std::map<std::string, std::map<std::string, double>> exact_figures(ReportedSweep& sweep,
                                                                   const SweepFolder& folder,
                                                                   const Store& store) {
  std::map<std::string, std::map<std::string, double>> all;
  if (sweep.state == "done")
    for (auto& row : csv_rows(whole_file(folder.file("figures.csv"))))
      if (const PointFigure* figure = figure_named(row["figure"], sweep.built());
          figure && figure->kind == PointFigure::Exact)
        all[row["point"]][figure->name] = std::strtod(row["value"].c_str(), nullptr);
  if (!sweep.plan.file.measure.silicon) {
    sweep.no_units = "the sweep does not measure silicon: [measure] silicon = \"generic\" does";
    return all;
  }
  bool any = false;
  try {
    const Silicon silicon(sweep.built());
    sweep.yosys = silicon.yosys();
    for (ReportedPoint& point : sweep.points) {
      point.units = units_of(silicon, store, point.k.front());
      if (point.units.empty()) continue;
      any = true;
      double cells = 0, flip_flops = 0;
      for (const ReportedUnit& unit : point.units) {
        cells += static_cast<double>(unit.cells);
        flip_flops += static_cast<double>(unit.flip_flops);
      }
      all[point.name]["cells"] = cells;
      all[point.name]["flip_flops"] = flip_flops;
    }
  } catch (const MissingTool& error) {
    sweep.no_units = error.what();
    return all;
  }
  if (!any) sweep.no_units = "no point's units have been synthesised by this RTL and this yosys";
  return all;
}

}  // namespace racebeam
