// SweepFile: a sweep as its author wrote it: which points, which frames, which goals.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tb/judge/picture_reference.h"
#include "tb/scene/engines.h"
#include "tb/scene/faults.h"
#include "tb/sweep/goal.h"
#include "tb/sweep/sweep_point.h"

namespace racebeam {

/// The values of a knob that a search takes, each once, in the order of the file.
struct KnobValues {
  const knob_row* row;
  std::vector<int> values;
  bool fixed = false;  ///< one value, no list: all points of the search have it
};

struct SweepFrames {
  int sample = 256;                                ///< of each point; 0: every frame
  std::vector<std::string> skip{"*ray pattern*"};  ///< parts left out: patterns as in a shell
  int guard = 64;                                  ///< the base point's worst frames
  /// Figures and how narrow their intervals shall be, in % of the mean.
  std::vector<std::pair<std::string, double>> until{};
  int most = 2048;  ///< frames of a point, however wide its intervals; at least sample

  /// Whether a part of a show is left out.
  bool skips(const std::string& part) const;
};

enum class SearchMethod { Grid, OneByOne, Sobol, Nsga2 };

struct SweepSearch {
  SearchMethod method = SearchMethod::Grid;
  int points = 64;         ///< that Sobol's sequence brings
  int population = 32;     ///< points of a generation of NSGA-II, the first one is Sobol's
  int generations = 12;    ///< of NSGA-II, beside the first one
  std::uint32_t seed = 1;  ///< of the search, and of the order of frames
  bool race = true;        ///< points that are surely dominated stop early

  /// It looks at goals to choose points: all must have the same frames.
  bool adapts() const { return method == SearchMethod::Nsga2; }
  bool races() const { return race && !adapts(); }
  /// Points that Sobol's sequence brings.
  int of_sobol() const { return adapts() ? population : points; }
};

using SweepReference = PictureReference;

/// Whose whole chips are mapped to technologies.
enum class SweepTiming { Off, Front, All };

struct SweepMeasure {
  bool causes = false;   ///< errors by cause
  bool silicon = false;  ///< generic cells and flip-flops
  SweepTiming timing = SweepTiming::Off;
  std::vector<int> pictures{};  ///< frames that are kept as pictures
  bool worst_picture = false;   ///< and the worst one
  SweepReference reference = SweepReference::Geometry;
};

struct SweepFile {
  static constexpr int MostPoints = 100'000;
  static constexpr int SmallestPopulation = 8;

  std::string name;
  std::vector<std::string> scenes{"demo"};  ///< as on the command line
  SweepFrames frames{};
  std::vector<KnobValues> knobs{};
  std::string where{};  ///< what the knobs of a search must hold, or empty
  Place where_place{}, knobs_place{};
  const engine* built = engines().front();  ///< who shows the scenes
  SweepPoint base{"chip", built->standard(nullptr)};
  std::vector<SweepPoint> points{};  ///< named ones; what they do not set is as in base
  SweepSearch search{};
  std::vector<Goal> goals{};
  SweepMeasure measure{};
};

/// What the file writes for the members of an enum, in their order.
const std::vector<std::string>& method_words();
const std::vector<std::string>& goal_words();  ///< from GoalKind::Min on
const std::vector<std::string>& reference_words();

/// `--set knob=value`: a search takes no other value of this knob, whatever the file says of it.
/// The base and the named points stay. Throws UsageError.
void narrow(SweepFile& file, const std::string& assignment);

}  // namespace racebeam
