// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/turn_reader.h"

#include <cstdlib>

namespace racebeam {

namespace {

constexpr int LargestStart = 65536, LargestStep = 1024, LargestEvery = 65536, LargestPerLine = 16;

// An eighth of a turn is written as 45 by who counts in degrees.
void warn_of_degrees(const TomlNode& node, const std::string& key, int value, Faults& faults) {
  constexpr int FullTurn = 360, Eighth = FullTurn / 8;
  if (value == 0 || value % Eighth != 0 || std::abs(value) > FullTurn) return;
  const int degrees = (value * FullTurn * 2 / TurnUnits + (value > 0 ? 1 : -1)) / 2;
  faults.warn(
      node.place,
      "'" + key + "' is " + std::to_string(value) + " of " + std::to_string(TurnUnits) +
          ": that is " + std::to_string(degrees) + " degrees",
      std::to_string(value) + " degrees are " + std::to_string(value * TurnUnits / FullTurn));
}

}  // namespace

void read_turn(const TableReader& camera, const std::string& key, int units, int frame, Turn& turn,
               const std::vector<FileKey>& keys) {
  const TomlNode* node = camera.find(key);
  if (!node) return;
  Turn next;
  next.start = frame > 0 ? turn.value(frame, 0, units) : turn.start;
  next.since = frame;
  if (node->kind == TomlNode::Table) {
    const TableReader table(*node, "turn", camera.faults(), keys);
    table.read("start", -LargestStart, LargestStart, next.start);
    table.read("step", -LargestStep, LargestStep, next.step);
    table.read("every", 1, LargestEvery, next.every);
    table.read("per_line", -LargestPerLine, LargestPerLine, next.per_line);
  } else {
    read_number(*node, key, -LargestStart, LargestStart, next.start, camera.faults());
  }
  const TomlNode* start = node->kind == TomlNode::Table ? node->find("start") : node;
  if (units == TurnUnits && start && start->kind == TomlNode::Integer)
    warn_of_degrees(*start, key, next.start, camera.faults());
  turn = next;
}

}  // namespace racebeam
