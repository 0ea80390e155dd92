// What a store keeps so that it is not made twice: the silicon of units and of chips, and pictures
// that points are compared with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tb/sweep/database.h"

namespace racebeam {

/// What synthesis says of a unit; its key is `hash`: of sources, parameters, recipe and yosys.
struct UnitSilicon {
  std::string hash, unit, parameters, recipe;
  std::int64_t flip_flops = 0, cells = 0;
  std::optional<double> area;  ///< if the recipe has one
};

class UnitCache {
 public:
  explicit UnitCache(Database& database) : database_(database) {}
  std::optional<UnitSilicon> find(const std::string& hash) const;
  /// One that is there stays.
  void put(const UnitSilicon& unit);

 private:
  Database& database_;
};

/// A whole chip in a technology; its key is `hash`, as of UnitSilicon.
struct MappedChip {
  std::string hash, top, parameters, technology;
  std::int64_t flip_flops = 0, cells = 0;   ///< cells of an FPGA: its LUTs
  std::optional<double> area, multipliers;  ///< if the technology has them; of all, of multipliers
  double ns = 0;                            ///< the longest path, with the setup time
  std::string from, to;                     ///< its registers: "u_subdivider.state_q[1]"
};

class ChipCache {
 public:
  explicit ChipCache(Database& database) : database_(database) {}
  std::optional<MappedChip> find(const std::string& hash) const;
  /// One that is there stays.
  void put(const MappedChip& chip);

 private:
  Database& database_;
};

/// Pictures, packed, and the pixels that the links of error chains change. The key: of model,
/// scene, frame, and what they depend on.
class ReferenceCache {
 public:
  explicit ReferenceCache(Database& database) : database_(database) {}
  bool has(const std::string& hash) const;
  std::optional<std::string> find(const std::string& hash) const;
  /// One that is there stays.
  void put(const std::string& hash, std::string_view picture);

 private:
  Database& database_;
};

}  // namespace racebeam
