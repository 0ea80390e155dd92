// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/front.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace racebeam {

namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A number that is surely from `low` to `high`.
struct Range {
  double low, mean, high;
  bool exact;  ///< nothing is left to chance

  Range negated() const { return {-high, -mean, -low, exact}; }
  bool surely_negative() const { return high < 0; }
  /// Frames in which two points are alike do not show that they are alike in all.
  bool surely_not_positive() const { return surely_negative() || (exact && high <= 0); }
};

Range range_of(double exact) { return {exact, exact, exact, true}; }
Range range_of(const Estimate& e) { return {e.low(), e.value, e.high(), e.all()}; }

/// Of a point by itself.
Range range_of(const Reading& reading, double confidence) {
  if (reading.kind == Reading::Exact) return range_of(reading.exact);
  if (reading.kind == Reading::Sampled) return range_of(mean_of(reading.frames, confidence));
  const Worst worst = worst_of(reading.frames);
  return {worst.value, worst.value, worst.all() ? worst.value : Infinity, worst.all()};
}

/// Of b - a.
Range change(const Reading& b, const Reading& a, double confidence) {
  if (b.kind == Reading::Exact) return range_of(b.exact - a.exact);
  if (b.kind == Reading::Sampled) return range_of(difference_of(b.frames, a.frames, confidence));
  const auto [of_b, of_a] = on_same_frames(b.frames, a.frames);
  const Worst worst_b = worst_of(of_b), worst_a = worst_of(of_a);
  const double mean = worst_b.value - worst_a.value;
  return worst_b.all() ? range_of(mean) : Range{-Infinity, mean, Infinity, false};
}

/// How far a point is beyond the limits of a goal; negative: it is within them.
Range beyond_limits(const Range& range, const Goal& goal) {
  Range beyond = {-Infinity, -Infinity, -Infinity, range.exact};
  const auto raise = [&](double low, double mean, double high) {
    beyond.low = std::max(beyond.low, low);
    beyond.mean = std::max(beyond.mean, mean);
    beyond.high = std::max(beyond.high, high);
  };
  if (goal.most) raise(range.low - *goal.most, range.mean - *goal.most, range.high - *goal.most);
  if (goal.least)
    raise(*goal.least - range.high, *goal.least - range.mean, *goal.least - range.low);
  return beyond;
}

class Judge {
 public:
  Judge(const std::vector<Candidate>& candidates, const std::vector<Goal>& goals, double confidence)
      : candidates_(candidates), goals_(goals), confidence_(confidence) {
    const double of_each = of_one_of(candidates.size());
    for (const Candidate& candidate : candidates) {
      own_.emplace_back();
      for (std::size_t goal = 0; goal < goals.size() && !candidate.stopped; ++goal)
        own_.back().push_back(range_of(candidate.readings.at(goal), of_each));
    }
    set_order();
  }

  Verdict verdict(std::size_t point) const {
    if (candidates_[point].stopped) return {};
    bool on_front = true;
    for (std::size_t goal = 0; goal < goals_.size(); ++goal) {
      const Range beyond = beyond_limits(own_[point][goal], goals_[goal]);
      if (beyond.low > 0) return {Verdict::Unwanted, int(goal)};
      on_front = on_front && beyond.mean <= 0;
    }
    const std::vector<Rival> rivals = rivals_of(point);
    const double of_each = of_one_of(rivals.size());
    for (const Rival& rival : rivals) {
      if (candidates_[rival.number].stopped) continue;
      const Dominance dominance = compared(rival, point, of_each);
      if (dominance.surely()) return {Verdict::Dominated, int(rival.number)};
      on_front = on_front && !dominance.by_mean();
    }
    return {on_front ? Verdict::Front : Verdict::Undecided, -1};
  }

 private:
  /// As far as goals have been compared.
  struct Dominance {
    bool no_worse = true, surely_no_worse = true, better = false, surely_better = false;

    bool possible() const { return no_worse || surely_no_worse; }
    bool surely() const { return surely_no_worse && surely_better; }
    bool by_mean() const { return no_worse && better; }
  };
  struct Rival {
    std::size_t number;
    Dominance dominance;  ///< in exact goals
  };

  /// Of an interval with one end that matters, so that `count` of them hold together.
  double of_one_of(std::size_t count) const {
    return for_best_of(int(count), 1 - 2 * (1 - confidence_));
  }

  /// Exact goals first, as they need no intervals; first of all the points that are the best in
  /// the last goal, as they dominate many.
  void set_order() {
    goal_order_.resize(goals_.size());
    std::iota(goal_order_.begin(), goal_order_.end(), std::size_t{0});
    order_.resize(candidates_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (candidates_.empty() || goals_.empty()) return;
    const auto sampled = std::stable_partition(
        goal_order_.begin(), goal_order_.end(),
        [&](std::size_t goal) { return candidates_[0].readings[goal].kind == Reading::Exact; });
    exact_goals_ = std::size_t(sampled - goal_order_.begin());
    const std::size_t goal = goal_order_.back();
    const auto going_on = std::stable_partition(
        order_.begin(), order_.end(), [&](std::size_t one) { return !candidates_[one].stopped; });
    std::stable_sort(order_.begin(), going_on, [&](std::size_t a, std::size_t b) {
      return less_is_better(goal, own_[a][goal]).mean < less_is_better(goal, own_[b][goal]).mean;
    });
  }

  Range less_is_better(std::size_t goal, const Range& range) const {
    return goals_[goal].kind == GoalKind::Max ? range.negated() : range;
  }

  std::vector<Rival> rivals_of(std::size_t point) const {
    std::vector<Rival> rivals;
    for (const std::size_t other : order_) {
      if (other == point) continue;
      Dominance dominance;
      for (std::size_t n = 0; n < exact_goals_ && dominance.possible(); ++n)
        compare(other, point, goal_order_[n], confidence_, dominance);
      if (dominance.possible()) rivals.push_back({other, dominance});
    }
    return rivals;
  }

  Dominance compared(const Rival& rival, std::size_t point, double confidence) const {
    Dominance dominance = rival.dominance;
    for (std::size_t n = exact_goals_; n < goal_order_.size() && dominance.possible(); ++n)
      compare(rival.number, point, goal_order_[n], confidence, dominance);
    return dominance;
  }

  void compare(std::size_t a, std::size_t b, std::size_t n, double confidence,
               Dominance& dominance) const {
    const Goal& goal = goals_[n];
    const Reading& reading = candidates_[a].readings[n];
    const Range from_b = change(reading, candidates_[b].readings[n], confidence);
    const Range own = reading.kind == Reading::Exact ? range_of(reading.exact) : own_[a][n];
    const Range beyond = beyond_limits(own, goal);
    dominance.no_worse = dominance.no_worse && beyond.mean <= 0;
    // Surely within the limits, or at least surely no further beyond them than b.
    dominance.surely_no_worse =
        dominance.surely_no_worse &&
        (beyond.high <= 0 || (!goal.least && from_b.surely_not_positive()) ||
         (!goal.most && from_b.negated().surely_not_positive()));
    if (goal.kind == GoalKind::Limit) return;
    const Range range = less_is_better(n, from_b);
    dominance.no_worse = dominance.no_worse && range.mean <= 0;
    dominance.surely_no_worse = dominance.surely_no_worse && range.surely_not_positive();
    dominance.better = dominance.better || range.mean < 0;
    dominance.surely_better = dominance.surely_better || range.surely_negative();
  }

  const std::vector<Candidate>& candidates_;
  const std::vector<Goal>& goals_;
  const double confidence_;
  std::vector<std::vector<Range>> own_;  // by candidate and goal
  std::vector<std::size_t> goal_order_, order_;
  std::size_t exact_goals_ = 0;  // the first of goal_order_
};

}  // namespace

std::vector<Verdict> judge(const std::vector<Candidate>& candidates, const std::vector<Goal>& goals,
                           double confidence) {
  const Judge judge(candidates, goals, confidence);
  std::vector<Verdict> verdicts;
  for (std::size_t point = 0; point < candidates.size(); ++point)
    verdicts.push_back(judge.verdict(point));
  return verdicts;
}

}  // namespace racebeam
