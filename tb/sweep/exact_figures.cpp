// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/exact_figures.h"

#include <fmt/format.h>

#include <sstream>

#include "tb/sweep/schema.h"

namespace racebeam {

namespace {

std::string note(std::int64_t model) { return fmt::format("exact figures of model {}", model); }

}  // namespace

void keep_exact(Store& store, std::int64_t model, const std::vector<ExactFigure>& figures) {
  std::string text;
  for (const ExactFigure& one : figures)
    text += fmt::format("{} {} {}\n", one.point, one.figure, one.value);
  if (text != store.notes.find(note(model))) store.notes.put(note(model), text);
}

std::vector<ExactFigure> kept_exact(const Store& store, std::int64_t model) {
  std::vector<ExactFigure> figures;
  for (const std::string& line : lines_of(store.notes.find(note(model)))) {
    std::istringstream words(line);
    ExactFigure one;
    if (words >> one.point >> one.figure >> one.value) figures.push_back(one);
  }
  return figures;
}

}  // namespace racebeam
