// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claims.h"

#include <cmath>
#include <map>
#include <memory>

#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/report/claim_arithmetic.h"
#include "tb/report/claim_figures.h"
#include "tb/report/claim_silicon.h"
#include "tb/show/set_knob.h"

namespace racebeam {

namespace {

/// A figure of a chip: exact, or by frames.
struct Quantity {
  std::optional<double> exact{};
  Strata frames{};
  std::string why_not{};

  bool there() const { return exact || !frames.empty(); }
};

Estimate scaled(Estimate estimate, double by) {
  estimate.value *= by;
  estimate.half_width *= std::abs(by);
  return estimate;
}

Estimate exactly(double value) { return {value, 0, 1, 1}; }

Estimate ratio(const Quantity& b, const Quantity& a) {
  if (b.exact && a.exact) return exactly(*b.exact / *a.exact);
  const auto [of_b, of_a] = on_same_frames(b.frames, a.frames);
  return ratio_of(of_b, of_a);
}

Estimate difference(const Quantity& b, const Quantity& a) {
  if (b.exact && a.exact) return exactly(*b.exact - *a.exact);
  return difference_of(b.frames, a.frames);
}

/// The value of each frame divided by that of another figure.
Quantity divided(const Quantity& b, const Quantity& a) {
  Quantity all;
  if (b.exact && a.exact) {
    all.exact = *b.exact / *a.exact;
    return all;
  }
  const auto [of_b, of_a] = on_same_frames(b.frames, a.frames);
  all.frames = of_b;
  for (std::size_t scene = 0; scene < of_b.size(); ++scene)
    for (std::size_t i = 0; i < of_b[scene].values.size(); ++i)
      all.frames[scene].values[i] /= of_a[scene].values[i];
  return all;
}

class Measurement {
 public:
  Measurement(const std::vector<Claim>& all, const ClaimSetting& setting,
              const ClaimWorkers& workers)
      : setting_(setting), workers_(workers) {
    for (const Claim& claim : all)
      for (const ClaimCheck& check : claim.checks) all_.push_back(&check);
  }

  bool measure(const std::vector<Claim>& chosen) {
    for (const Claim& claim : chosen)
      for (const ClaimCheck& check : claim.checks) want(check);
    for (auto& [name, scene] : scenes_)
      if (!scene->measure()) return false;
    try {
      if (silicon_) silicon_->measure(setting_.jobs);
    } catch (const Interrupted&) {
      return false;
    }
    return true;
  }

  CheckFinding find(const ClaimCheck& check) const {
    CheckFinding finding;
    const Quantity of = read(check, check.figure, check.of);
    const bool compared = check.as != ClaimCheck::Value;
    const Quantity other = compared ? read(check, check.figure, check.against) : Quantity{0.0};
    const Quantity per = check.per.empty() ? Quantity{1.0} : read(check, check.per, check.of);
    for (const Quantity* one : {&of, &other, &per})
      if (!one->there()) {
        finding.why_not = one->why_not;
        return finding;
      }
    finding.sampled = !of.exact;
    finding.found = scaled(estimate(check, of, other, per), check.times);
    finding.verdict = verdict_of(check, *finding.found);
    return finding;
  }

 private:
  Estimate estimate(const ClaimCheck& check, const Quantity& of, const Quantity& other,
                    const Quantity& per) const {
    const bool is_ratio = !check.per.empty();
    if (check.as == ClaimCheck::Value) {
      if (is_ratio) return ratio(of, per);
      return of.exact ? exactly(*of.exact) : mean_of(of.frames);
    }
    const Quantity other_per = is_ratio ? read(check, check.per, check.against) : per;
    const Quantity b = is_ratio ? divided(of, per) : of;
    const Quantity a = is_ratio ? divided(other, other_per) : other;
    if (check.as == ClaimCheck::Difference) return difference(b, a);
    Estimate change = ratio(b, a);
    change.value -= 1;
    return scaled(change, 100);
  }

  ClaimScene& scene(const std::string& name) {
    std::unique_ptr<ClaimScene>& one = scenes_[name];
    if (!one) one = std::make_unique<ClaimScene>(name, all_, setting_, workers_);
    return *one;
  }

  void want(const ClaimCheck& check) {
    for (const std::string* figure : {&check.figure, &check.per}) {
      if (figure->empty()) continue;
      for (const auto* side : {&check.of, &check.against}) {
        if (side == &check.against && check.as == ClaimCheck::Value) continue;
        switch (*claim_source(*figure)) {
          case ClaimSource::Arithmetic: break;
          case ClaimSource::Frames:
          case ClaimSource::Golden: scene(check.scene).want(*figure, *side); break;
          case ClaimSource::Silicon:
            if (!silicon_) silicon_.emplace(scene("demo").store());
            silicon_->want(*silicon_figure(*figure), knobs_of(*side));
        }
      }
    }
  }

  knob_values knobs_of(const std::vector<std::string>& side) const {
    knob_values k = beam_engine().standard(nullptr);
    for (const auto* list : {&setting_.base, &side})
      for (const std::string& one : *list) set_knob(k, one);
    beam_engine().settle(k);
    return k;
  }

  Quantity read(const ClaimCheck& check, const std::string& figure,
                const std::vector<std::string>& side) const {
    Quantity quantity;
    switch (*claim_source(figure)) {
      case ClaimSource::Arithmetic:
        quantity.exact = arithmetic_figure(figure)->value(knobs(knobs_of(side)));
        break;
      case ClaimSource::Silicon:
        quantity.exact = silicon_->value(*silicon_figure(figure), knobs_of(side));
        quantity.why_not = silicon_->why(*silicon_figure(figure), knobs_of(side));
        break;
      case ClaimSource::Frames:
      case ClaimSource::Golden: {
        const ClaimScene& scene = *scenes_.at(check.scene);
        quantity.frames = scene.read(figure, side);
        quantity.why_not = scene.failure(side);
      }
    }
    return quantity;
  }

  const ClaimSetting& setting_;
  const ClaimWorkers& workers_;
  std::vector<const ClaimCheck*> all_;
  std::map<std::string, std::unique_ptr<ClaimScene>> scenes_;
  std::optional<ClaimSilicon> silicon_;
};

}  // namespace

std::optional<std::vector<ClaimFinding>> measure_claims(const std::vector<Claim>& chosen,
                                                        const std::vector<Claim>& all,
                                                        const ClaimSetting& setting,
                                                        const ClaimWorkers& workers) {
  Measurement measurement(all, setting, workers);
  if (!measurement.measure(chosen)) return {};
  std::vector<ClaimFinding> findings;
  for (const Claim& claim : chosen) {
    ClaimFinding& finding = findings.emplace_back();
    finding.claim = claim;
    for (const ClaimCheck& check : claim.checks) finding.checks.push_back(measurement.find(check));
  }
  return findings;
}

}  // namespace racebeam
