// Comparison: scenes by engines, side by side.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/report/compared_cell.h"

namespace racebeam {

/// A scene to be drawn from a picture on.
struct CompareScene {
  std::string scene;
  int first = 0;
  std::vector<std::string> settings{};  ///< "block.cores=1", for the engines that draw it
};

/// A table: each engine draws the first of the scenes that it can.
struct CompareGroup {
  std::string name;
  std::vector<CompareScene> scenes;
};

/// What each engine was made for, and what several draw.
const std::vector<CompareGroup>& common_groups();

/// A column of a table.
struct ComparedEngine {
  std::string engine;
  std::string why;  ///< it draws nothing
  std::optional<ComparedCell> cell{};
};

struct ComparedGroup {
  std::string name;
  std::vector<ComparedEngine> engines;
};

struct CompareSetting {
  std::vector<const racebeam::engine*> engines;
  std::vector<std::string> assignments;  ///< "sphere.fraction_bits=10"
  int pictures = 1;
};

/// Every cell in a process of its own. Throws UsageError: bad scenes, knobs, a group that no engine
/// draws.
ComparedGroup compare_group(const CompareGroup& group, const CompareSetting& setting);

/// For people, and as Markdown: a table with the reasons below it.
std::string compared_text(const ComparedGroup& group);
std::string compared_markdown(const ComparedGroup& group);

/// compare.json, schema "racebeam-compare" version 1: {figures, numbers, quantities: what the names
/// mean, groups: [{name, engines: [{engine, why} or {engine, scene, first, knobs, numbers,
/// quantities: {name: {formula, value}}, figures: {name: value}}]}]}. A figure that an engine does
/// not have is null, one without an end is "infinite".
std::string compared_json(const std::vector<ComparedGroup>& groups);

}  // namespace racebeam
