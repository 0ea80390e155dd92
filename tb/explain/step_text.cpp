// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/step_text.h"

#include <fmt/format.h>

#include "sc/beam/subdivider_core.h"

namespace racebeam {

namespace {

constexpr int XOrY = 6, Exit = 7;  // levels; below them the four edges of an opening

bool asks_signs(const TracerStep& step) { return step.depth == 0 && step.level < 4; }

}  // namespace

std::string face_text(int axis, bool negative) {
  return fmt::format("{} {}{}", face_name(2 * axis + negative), negative ? '-' : '+', "xyz"[axis]);
}

const char* state_name(int state) {
  constexpr const char* names[] = {"LEFT", "RIGHT", "BISECT", "RETURN"};
  return names[state];
}

const char* end_name(IntervalEnd end) {
  constexpr const char* names[] = {"solid", "missed", "too_deep", "given_up", "never"};
  return names[static_cast<int>(end)];
}

std::string question_text(const TracerStep& step) {
  if (asks_signs(step)) return "signs of the ray";
  if (step.level == XOrY) return "x or y first";
  if (step.level == Exit) return step.y_first ? "y or z first" : "x or z first";
  const int axis = (step.face + 2 - (step.level & 1)) % 3;  // along which the edge bounds
  return fmt::format("{} edge in {}", step.level < 2 ? "far" : "near", "xyz"[axis]);
}

std::string answer_text(const TracerStep& step) {
  if (!step.decision) return "";
  if (asks_signs(step)) {
    std::string signs;
    for (int axis = 0; axis < 3; ++axis) signs += bit_of(step.answer, axis) ? '-' : '+';
    return signs;
  }
  const bool bit = step.answer & 1;
  if (step.level == XOrY) return bit ? "y" : "x";
  if (step.level == Exit) return step.y_first ? (bit ? "z" : "y") : (bit ? "x" : "z");
  return bit ? "outside" : "inside";
}

std::vector<std::string> outcomes(const TracerStep& step) {
  std::vector<std::string> words;
  const auto add = [&](bool is, const char* word) {
    if (is) words.emplace_back(word);
  };
  add(step.walks, "walk to the right end");
  add(step.decision && step.state == StateLeft && !step.descends, "ask the right end");
  add(step.decision && step.state >= StateRight && !step.agrees && !step.pushes, "differs: bisect");
  add(step.decision && step.state == StateBisect && step.agrees && !step.pushes, "same: bisect");
  add(step.pushes, "push");
  add(step.descends, "descend");
  add(step.second && !step.offers && step.state != StateReturn, "enter");
  add(step.finds_wall, "wall");
  add(step.offers && !step.emits, "wait");
  add(step.emits, "emit");
  add(step.climbs, "climb");
  add(step.pops, "pop");
  add(step.restarts, "restart");
  return words;
}

}  // namespace racebeam
