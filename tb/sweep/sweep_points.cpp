// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_points.h"

#include <boost/random/sobol.hpp>
#include <map>
#include <optional>
#include <random>

#include "tb/sweep/knob_condition.h"

namespace racebeam {

namespace {

class PointMaker {
 public:
  PointMaker(const SweepFile& file, const std::vector<knob_values>& standards)
      : file_(file), standards_(standards) {
    if (!file.where.empty()) where_.emplace(*file.built, file.where);
    add(file.base);
    for (const SweepPoint& point : file.points) add(point);
  }

  SweepPoints make(const std::vector<ValueIndices>& more) {
    switch (file_.search.method) {
      case SearchMethod::Grid: ask_grid(); break;
      case SearchMethod::OneByOne: ask_one_by_one(); break;
      case SearchMethod::Sobol:
      case SearchMethod::Nsga2: ask_sobol(); break;
    }
    for (const ValueIndices& indices : more) {
      ask(at(indices));
      made_.asked.emplace_back(indices, answer_);
    }
    return std::move(made_);
  }

 private:
  struct Known {
    std::string name;
    int place = 0;  // among the points
    bool asked = false;
  };

  // All values on all scenes.
  std::vector<int> key_of(const SweepPoint& point) const {
    std::vector<int> key;
    for (const knob_values& standard : standards_) {
      const knob_values k = knobs_on(point, standard);
      for (std::size_t row = 0; row < k.rows().size(); ++row) key.push_back(k[row]);
    }
    return key;
  }

  void keep(SweepPoint point) {
    file_.built->settle(point.k);
    made_.points.push_back(std::move(point));
  }

  int count() const { return static_cast<int>(made_.points.size()); }

  void add(const SweepPoint& point) {
    const auto [at, is_new] = known_.emplace(key_of(point), Known{point.name, count()});
    if (is_new) keep(point);
    else made_.same.emplace_back(point.name, at->second.name);
  }

  // Whether the point is one that the search has not asked for.
  bool ask(SweepPoint point) {
    if (where_ && !where_->holds(point.k)) {
      ++made_.refused;
      answer_ = -1;
      return false;
    }
    const auto [at, is_new] = known_.emplace(key_of(point), Known{"", count()});
    answer_ = at->second.place;
    if (at->second.asked) {
      ++made_.again;
      return false;
    }
    at->second.asked = true;
    ++made_.of_search;
    if (!is_new) return true;
    point.name = at->second.name = "p" + std::to_string(made_.of_search);
    keep(std::move(point));
    return true;
  }

  // The base with the value of this index of each knob.
  SweepPoint at(const ValueIndices& indices) const {
    SweepPoint point = file_.base;
    for (std::size_t i = 0; i < indices.size(); ++i)
      point.set_knob(*file_.knobs[i].row, file_.knobs[i].values[indices[i]]);
    return point;
  }

  void ask_grid() {
    ValueIndices indices(file_.knobs.size());
    for (;;) {
      ask(at(indices));
      std::size_t knob = indices.size();
      while (knob > 0 && ++indices[knob - 1] == file_.knobs[knob - 1].values.size())
        indices[--knob] = 0;
      if (knob == 0) return;
    }
  }

  void ask_one_by_one() {
    SweepPoint middle = file_.base;
    for (const KnobValues& knob : file_.knobs)
      if (knob.fixed) middle.set_knob(*knob.row, knob.values.front());
    if (middle.k != file_.base.k) ask(middle);
    for (const KnobValues& knob : file_.knobs)
      for (const int value : knob.values) {
        if (knob.fixed) continue;
        SweepPoint point = middle;
        point.set_knob(*knob.row, value);
        ask(std::move(point));
      }
  }

  void ask_sobol() {
    constexpr int Patience = 10'000;
    const std::size_t count = file_.knobs.size();
    const int wanted = file_.search.of_sobol();
    if (count == 0) return;
    boost::random::sobol sequence(count);
    std::mt19937_64 shift(file_.search.seed);
    std::vector<std::uint64_t> shifts(count), vector(count);  // the sequence begins at 0, ...
    for (std::uint64_t& one : shifts) one = shift();
    ValueIndices indices(count);
    for (int without = 0; without < Patience && made_.of_search < wanted; ++without) {
      for (std::size_t i = 0; i < count; ++i)
        indices[i] = ((vector[i] ^ shifts[i]) >> 32) * file_.knobs[i].values.size() >> 32;
      if (ask(at(indices))) {
        without = 0;
        made_.asked.emplace_back(indices, answer_);
      }
      for (std::uint64_t& one : vector) one = sequence();  // ... which boost leaves out
    }
  }

  const SweepFile& file_;
  const std::vector<knob_values>& standards_;
  std::optional<KnobCondition> where_;
  std::map<std::vector<int>, Known> known_;
  int answer_ = -1;  // where the point asked for last stands
  SweepPoints made_{};
};

}  // namespace

double grid_points(const SweepFile& file) {
  double count = 1;
  for (const KnobValues& knob : file.knobs) count *= static_cast<double>(knob.values.size());
  return count;
}

SweepPoints sweep_points(const SweepFile& file, const std::vector<knob_values>& standards,
                         const std::vector<ValueIndices>& more) {
  return PointMaker(file, standards).make(more);
}

SweepPoints sweep_points(const SweepFile& file) {
  return sweep_points(file, {file.built->standard(nullptr)});
}

}  // namespace racebeam
