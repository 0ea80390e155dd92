// ReportedSweep: a sweep as its folder has it, finished or not, for whoever shows it.
//
// Nothing is written and nothing measured: somebody else may be running the sweep meanwhile. All
// numbers come from where those of the sweep's own summary and of figures.csv do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/sweep/begun_folder.h"
#include "tb/sweep/point_reading.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

struct ReportedFigure {
  bool there = false;
  Estimate value{};                  ///< of designs, and largest values: without an interval
  std::optional<Estimate> change{};  ///< against the base, on the same frames
};

/// The cells and flip-flops of a point's chip, by unit.
struct ReportedUnit {
  std::string unit;
  std::int64_t cells = 0, flip_flops = 0;
};

struct ReportedPoint {
  std::string name;
  std::vector<FrameKey> keys{};           ///< by scene
  std::vector<knob_values> k{};           ///< by scene
  std::string standing{};                 ///< "front", "measured", "failed", "not measured" ...
  std::string reason{};                   ///< why it stands so; "": nothing is to be said
  int frames = 0;                         ///< of the sample, of all scenes
  std::vector<ReportedFigure> figures{};  ///< by ReportedSweep::figures
  std::vector<PointReading> led{};        ///< by ReportedSweep::led
  std::vector<ReportedUnit> units{};      ///< if all are known

  bool failed() const { return standing == "failed"; }
  bool measured() const { return frames > 0 && !failed(); }
  bool on_front() const { return standing == "front"; }
};

struct ReportedSweep {
  std::string name, state;  ///< "done", "running", "interrupted", or "" if nobody said
  SweepPlan plan;
  StoredModel model{};                        ///< id 0: nothing has been measured
  std::vector<const PointFigure*> figures{};  ///< that some point has, in the table's order
  std::vector<const PointFigure*> led{};      ///< goals, then what says at what price
  std::vector<std::size_t> knobs{};           ///< rows of those that vary
  std::vector<ReportedPoint> points{};        ///< the base first, if there is any
  std::vector<Candidate> candidates{};        ///< that were judged, the base first
  std::vector<Verdict> verdicts{};            ///< of each
  std::vector<SweepRun> runs{};
  std::vector<std::string> remarks{};  ///< of its state: what is not as it should be
  std::string yosys{};                 ///< its version, if it was asked
  std::string no_units{};              ///< why there are no cells by unit; "": there are

  const engine& built() const { return *plan.file.built; }
  int failed() const;
  int measured() const;
  /// Of a point: the figure of this name; nullptr if it is not there.
  const ReportedFigure* figure(const ReportedPoint& point, const std::string& name) const;
};

/// A sweep with its store, which is open as long as this lives.
class SweepReader {
 public:
  /// Throws UsageError if `path` is not the folder of a sweep that has begun, and what Database
  /// throws.
  explicit SweepReader(const std::string& path);

  const BegunFolder& folder() const { return folder_; }
  const ReportedSweep& sweep() const { return sweep_; }
  const FrameTable& frames() const { return store_.frames; }

 private:
  void read_points();
  void read_state();
  void read_figures_of_points();
  void judge_points();

  BegunFolder folder_;
  Store store_;
  ReportedSweep sweep_;
  std::vector<std::int64_t> scenes_{};  // ids of the plan's scenes; 0: nothing is of it
  std::map<std::string, std::map<std::string, double>> exact_{};  // by point and figure
  int frames_ = 0;                                                // of a point, at most
};

}  // namespace racebeam
