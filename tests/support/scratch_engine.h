// An engine of two knobs and no units, whose pictures take their own time: what works with any
// engine is to take it for one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sc/base/wired_chip.h"
#include "sc/swap/rtl_parameters.h"
#include "tb/scene/scene_kinds.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

struct scratch_knobs {
  int cells = 8;
  int order = 0;
};

inline const std::vector<knob_of<scratch_knobs>>& scratch_table() {
  static const std::vector<knob_of<scratch_knobs>> table = {
      {{"cells", 1, 64, {}, "cells", "how many there are", "nowhere"}, &scratch_knobs::cells},
      {{"order", 0, 1, {"rows", "columns"}, "", "which way", "nowhere"}, &scratch_knobs::order}};
  return table;
}

inline const std::vector<knob_row>& scratch_rows() {
  static const std::vector<knob_row> rows = rows_of(scratch_table());
  return rows;
}

inline knob_values values_of(const scratch_knobs& k) {
  return values_of(scratch_table(), scratch_rows(), k);
}

struct scratch_tables : scene_tables {
  double zoom = 1;
  std::array<double, 3> eye{};
  std::uint32_t sky = 0;
};

inline const engine& scratch_engine() {
  static const std::vector<unit_row> no_units;
  static const engine row = {"scratch",
                             "for a test",
                             {"tlm"},
                             "",
                             false,
                             no_units,
                             scratch_rows(),
                             {{"words", "words", 8}},
                             {{"fill", "cells"}},
                             {},
                             {},
                             [](const scene_tables*) { return values_of(scratch_knobs()); },
                             [](knob_values&) { return std::string(); },
                             [](const knob_values& k, const scene_tables*) {
                               return std::string(k.of("cells") > 32 ? "too many cells" : "");
                             },
                             [](const knob_values&) { return video_clocks{1}; },
                             [](const char*, const knob_values&, const scene_tables*,
                                const unit_choices&) { return std::unique_ptr<wired_chip>(); },
                             [](const knob_values&) { return std::vector<rtl_parameter>(); }};
  return row;
}

class ScratchScene final : public AnyScene {
 public:
  const racebeam::engine& engine() const override { return scratch_engine(); }
  const std::string& name() const override { return name_; }
  int frames() const override { return 5; }
  const scratch_tables& tables() const override { return tables_; }
  std::string part(int frame) const override { return "picture " + std::to_string(frame); }
  std::string counts() const override { return "1 sky"; }

  std::string name_;
  scratch_tables tables_;
};

inline const std::vector<FileKey>& scratch_keys() {
  static const std::vector<FileKey> keys = {{"", "engine", "name", "beam", "scratch"},
                                            {"", "zoom", "0.5..8", "1", "how near"},
                                            {"", "eye", "[x, y, z]", "0", "where from"},
                                            {"", "sky", "\"#rrggbb\"", "black", "its colour"}};
  return keys;
}

inline std::shared_ptr<const AnyScene> read_scratch(const SceneText& file, Faults& faults) {
  auto scene = std::make_shared<ScratchScene>();
  scene->name_ = file.name;
  const TableReader top(file.root, "", faults, scratch_keys());
  top.read("zoom", 0.5, 8.0, scene->tables_.zoom);
  top.read("eye", -1000.0, 1000.0, scene->tables_.eye);
  top.read_rgb("sky", scene->tables_.sky);
  if (!faults.none()) return nullptr;
  return scene;
}

/// The product's kinds, and this one.
inline std::vector<SceneKind> kinds_with_scratch() {
  std::vector<SceneKind> kinds = scene_kinds();
  kinds.push_back({scratch_engine(), scratch_keys(), read_scratch});
  return kinds;
}

}  // namespace racebeam
