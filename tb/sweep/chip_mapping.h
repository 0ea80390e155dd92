// Whole chips in a technology: cells, area and the longest path, by scripts/timing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/sweep/silicon.h"
#include "tb/sweep/store_caches.h"
#include "tb/sweep/synthesis.h"

namespace racebeam {

constexpr const char* StandardCells = "osu018";
constexpr const char* Fpga = "ice40";

/// A chip without its sound that shall be mapped.
struct ChipWanted {
  UnitParameters chip;  ///< the hash: of this run, with all that it depends on
  std::string technology;
  std::vector<std::string> words;  ///< of the script
};

struct ChipOutcome {
  std::optional<MappedChip> mapped;
  std::string fault;  ///< "racebeam_top with FifoEntries=12: osu018 did not end within 600 seconds"
};

class Technology {
 public:
  /// Asks its tools for their versions. Throws MissingTool if one is not there or does not answer;
  /// Interrupted. `silicon` outlives this.
  Technology(const Silicon& silicon, const std::string& name);

  const std::string& name() const { return name_; }
  /// Throws NoSilicon.
  ChipWanted chip_of(const knob_values& k) const;

 private:
  const Silicon& silicon_;
  std::string name_, recipe_;  // recipe_: a key of script and tools
};

/// Runs all of them as synthesise() does.
void map_chips(const std::vector<ChipWanted>& chips, const SynthesisPlan& plan,
               const std::function<void(const ChipWanted&, const ChipOutcome&)>& done);

/// The limit of a chip.
constexpr std::chrono::minutes ChipLimit{10};

/// How many tiles of Tiny Tapeout an area of osu018 would take: an estimate. As many NAND gates of
/// sky130 have 3.75 square micrometres each instead of 24, and fill 60 % of tiles of 161 x 111.52.
double estimated_tiles(double area);

}  // namespace racebeam
