// libracebeam_search.so: the one file of the program that knows pagmo.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/config.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "tb/sweep/nsga2_library.h"

namespace racebeam {

namespace {

using pagmo::vector_double;

/// The knobs that have a choice are its variables, all of them whole numbers.
class SweepProblem {
 public:
  SweepProblem() = default;  // pagmo asks for it
  SweepProblem(const Nsga2Search& search, const std::function<Goals(const Generation&)>& ask)
      : search_(search), ask_(&ask) {
    for (std::size_t knob = 0; knob < search.values.size(); ++knob)
      if (search.values[knob] > 1) knobs_.push_back(knob);
  }

  std::size_t variables() const { return knobs_.size(); }
  vector_double variables_of(const ValueIndices& point) const {
    vector_double x;
    for (const std::size_t knob : knobs_) x.push_back(static_cast<double>(point[knob]));
    return x;
  }

  vector_double fitness(const vector_double& x) const { return batch_fitness(x); }
  vector_double batch_fitness(const vector_double& points) const {
    Generation asked;
    for (auto x = points.begin(); x != points.end(); x += std::ptrdiff_t(variables())) {
      ValueIndices point(search_.values.size());
      for (std::size_t i = 0; i < knobs_.size(); ++i)
        point[knobs_[i]] = static_cast<std::size_t>(x[std::ptrdiff_t(i)]);
      asked.push_back(std::move(point));
    }
    vector_double all;
    for (const std::vector<double>& goals : (*ask_)(asked))
      all.insert(all.end(), goals.begin(), goals.end());
    return all;
  }
  vector_double::size_type get_nobj() const { return search_.goals; }
  vector_double::size_type get_nix() const { return variables(); }
  std::pair<vector_double, vector_double> get_bounds() const {
    vector_double last;
    for (const std::size_t knob : knobs_)
      last.push_back(static_cast<double>(search_.values[knob] - 1));
    return {vector_double(variables(), 0), last};
  }

 private:
  Nsga2Search search_{};
  const std::function<Goals(const Generation&)>* ask_ = nullptr;
  std::vector<std::size_t> knobs_;  // that have more than one value
};

void search(const Nsga2Search& search, const Generation& first,
            const std::function<Goals(const Generation&)>& ask) {
  // Deb's and pagmo's usual values; one knob of a point changes by chance, on average.
  constexpr double Crossover = 0.95, CrossoverSpread = 10, MutationSpread = 50;
  const SweepProblem problem(search, ask);
  pagmo::population points(pagmo::problem(problem), 0, search.seed);
  const Goals goals = ask(first);
  for (std::size_t i = 0; i < first.size(); ++i)
    points.push_back(problem.variables_of(first[i]), goals.at(i));
  pagmo::nsga2 nsga2(static_cast<unsigned>(search.generations), Crossover, CrossoverSpread,
                     1 / static_cast<double>(problem.variables()), MutationSpread, search.seed);
  nsga2.set_bfe(pagmo::bfe());  // the problem's own, a whole generation at once
  nsga2.evolve(points);
}

std::string version() { return PAGMO_VERSION; }

}  // namespace
}  // namespace racebeam

extern "C" {
extern const racebeam::Nsga2Library racebeam_nsga2_library;
const racebeam::Nsga2Library racebeam_nsga2_library = {racebeam::version, racebeam::search};
}
