// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_scene.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "sc/beam/engine.h"
#include "tb/base/console.h"
#include "tb/base/interrupt.h"
#include "tb/report/claim_figures.h"
#include "tb/show/set_knob.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/repeats.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/sweep_changes.h"
#include "tb/sweep/sweep_summary.h"

namespace racebeam {

namespace {

constexpr std::size_t GoldenBlock = 8;  // frames: a second or two of work

std::string folder_name(std::string scene) {
  std::replace(scene.begin(), scene.end(), '/', '_');
  return scene;
}

knob_values knobs_with(const std::vector<std::string>& base, const std::vector<std::string>& side) {
  knob_values k = beam_engine().standard(nullptr);
  for (const auto* list : {&base, &side})
    for (const std::string& one : *list) set_knob(k, one);
  beam_engine().settle(k);
  return k;
}

/// "{ bisection = \"pow2\", dr_bits = 9 }"
std::string toml_knobs(const std::vector<std::string>& assignments) {
  std::string text;
  for (const std::string& one : assignments) {
    const std::size_t is = one.find('=');
    const std::string name = one.substr(0, is), value = one.substr(is + 1);
    const bool is_name = !swept_knob(beam_engine(), name)->names.empty();
    text += fmt::format("{} {} = {}", text.empty() ? "" : ",", name,
                        is_name ? "\"" + value + "\"" : value);
  }
  return "{" + text + " }";
}

/// Whether a chip has to show frames for it.
bool is_of_frames(const std::string& figure) {
  const auto source = claim_source(figure);
  return source == ClaimSource::Frames || source == ClaimSource::Golden;
}

/// The sweep whose points are the chips of all claims.
std::string sweep_text(const std::string& scene, const std::vector<const ClaimCheck*>& all,
                       const ClaimSetting& setting) {
  std::string text = fmt::format(
      "# Written by racebeam claims: the chips that the claims are about.\n"
      "name = \"claims\"\nscenes = [\"{}\"]\n\n"
      "[frames]\nsample = {}\nguard = 0\n\n[measure]\nsilicon = \"off\"\n\n[base]\nknobs = {}\n",
      scene, setting.frames == 0 ? "\"all\"" : std::to_string(setting.frames),
      toml_knobs(setting.base));
  std::vector<knob_values> there = {knobs_with(setting.base, {})};
  for (const ClaimCheck* check : all)
    for (const auto* side : {&check->of, &check->against}) {
      const knob_values k = knobs_with(setting.base, *side);
      if (check->scene != scene || !is_of_frames(check->figure) ||
          std::find(there.begin(), there.end(), k) != there.end())
        continue;
      there.push_back(k);
      text += fmt::format("\n[[point]]\nname = \"{}\"\nknobs = {}\n", fmt::join(*side, " "),
                          toml_knobs(*side));
    }
  return text;
}

/// All that a worker says, until it ends.
std::string said_by(const ForkServer::Worker& worker) {
  std::string text;
  char some[4096];
  for (ssize_t n = 0; (n = read(worker.file, some, sizeof some)) > 0;)
    text.append(some, static_cast<std::size_t>(n));
  close(worker.file);
  return text;
}

}  // namespace

ClaimScene::ClaimScene(const std::string& scene, const std::vector<const ClaimCheck*>& all,
                       const ClaimSetting& setting, const ClaimWorkers& workers)
    : setting_(setting),
      golden_workers_(workers.golden),
      plan_(plan_sweep_text(sweep_text(scene, all, setting), "claims")),
      folder_(setting.folder + "/" + folder_name(scene), Access::Write),
      store_(folder_.store(), Access::Write),
      model_(open_model(store_, plan_, folder_.path(), setting.fresh)),
      progress_(plan_, folder_),
      measurer_(plan_, folder_, store_, model_, workers.frames, setting.jobs,
                [this] { progress_.look(measurer_, plan_.sample(0)); }),
      state_(plan_, store_, measurer_) {
  folder_.keep_sweep(plan_.text);
  keep_scenes(store_, plan_);
}

std::size_t ClaimScene::point_of(const std::vector<std::string>& side) const {
  const knob_values k = knobs_with(setting_.base, side);
  for (std::size_t point = 0; point < plan_.points.size(); ++point)
    if (plan_.points[point].point.k == k) return point;
  throw std::logic_error("a claim's chip is no point of its sweep");
}

const knob_values& ClaimScene::knobs_of(const std::vector<std::string>& side) const {
  return plan_.points[point_of(side)].k.front();
}

std::string ClaimScene::failure(const std::vector<std::string>& side) const {
  return measurer_.failure(static_cast<int>(point_of(side)));
}

std::vector<int> ClaimScene::first_frames(int most) const {
  const std::vector<int>& order = plan_.scenes.front().order;
  return {order.begin(), order.begin() + std::min(plan_.sample(0), most)};
}

void ClaimScene::want(const std::string& figure, const std::vector<std::string>& side) {
  const int point = static_cast<int>(point_of(side));
  if (claim_source(figure) == ClaimSource::Frames) points_.insert({0, point});
  if (claim_source(figure) == ClaimSource::Golden)
    golden_.insert({point, golden_figure(figure)->set});
}

bool ClaimScene::measure() {
  if (!repeats_as_stored(plan_, store_, model_, measurer_)) return false;
  std::vector<Want> wants;
  for (const int point : points_) wants.push_back({point, 0, first_frames(plan_.sample(0))});
  const int missing = measurer_.missing(wants);
  const std::int64_t run =
      missing > 0 ? store_.runs.begin(this_run(setting_.command, setting_.jobs)) : 0;
  if (missing > 0) tell(plan_text(plan_, measurer_.missing(wants) == 0));
  const bool whole = measurer_.measure(wants) && measure_golden();
  if (missing > 0) store_.runs.end(run, cpu_seconds());
  progress_.end(measurer_, plan_.sample(0), whole);
  return whole;
}

// All that its numbers depend on.
std::string ClaimScene::note(int point, const GoldenSet& set, int frame) const {
  const PlannedPoint& of = plan_.points[static_cast<std::size_t>(point)];
  return fmt::format("claims {} {} {} {} {}", set.name, model_hash(beam_engine().name),
                     plan_.scenes.front().show.hash(), text_hash(point_text(of.k.front())), frame);
}

bool ClaimScene::measure_golden() {
  std::vector<GoldenRequest> requests;
  std::vector<GoldenKey> keys;
  for (const GoldenKey& key : golden_) {
    std::size_t size = 0;
    for (const int frame : first_frames(ClaimSetting::GoldenMost)) {
      if (!store_.notes.find(note(key.first, *key.second, frame)).empty()) continue;
      if (size++ % GoldenBlock == 0) {
        const SweepScene& scene = plan_.scenes.front();
        requests.push_back({scene.name,
                            key.second->name,
                            plan_.points[static_cast<std::size_t>(key.first)].k.front(),
                            {}});
        keys.push_back(key);
      }
      requests.back().frames.push_back(frame);
    }
  }
  return run_golden(requests, keys);
}

bool ClaimScene::run_golden(const std::vector<GoldenRequest>& requests,
                            const std::vector<GoldenKey>& keys) {
  const auto jobs = static_cast<std::size_t>(setting_.jobs);
  std::vector<ForkServer::Worker> workers;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (interrupted()) return false;
    while (workers.size() < std::min(i + jobs, requests.size()))
      workers.push_back(golden_workers_.start(golden_request(requests[workers.size()])));
    const auto answers = golden_answer(said_by(workers[i]));
    golden_workers_.wait(workers[i]);
    Transaction block(store_.database());
    for (const auto& [frame, values] : answers)
      store_.notes.put(note(keys[i].first, *keys[i].second, frame),
                       fmt::format("{}", fmt::join(values, " ")));
    block.commit();
    progress_.look(measurer_, plan_.sample(0));
  }
  return true;
}

Strata ClaimScene::read(const std::string& figure, const std::vector<std::string>& side) const {
  const int point = static_cast<int>(point_of(side));
  if (claim_source(figure) == ClaimSource::Frames) {
    if (!measurer_.failure(point).empty()) return {};
    return state_.read(point, *figure_named(figure, beam_engine()), plan_.sample(0)).reading.frames;
  }
  const GoldenFigure& of = *golden_figure(figure);
  Stratum stratum;
  stratum.population = static_cast<int>(plan_.scenes.front().order.size());
  std::vector<int> frames = first_frames(ClaimSetting::GoldenMost);
  std::sort(frames.begin(), frames.end());
  for (const int frame : frames) {
    std::istringstream values(store_.notes.find(note(point, *of.set, frame)));
    double value = 0;
    for (std::size_t column = 0; column <= of.column; ++column) values >> value;
    stratum.frames.push_back(frame);
    stratum.values.push_back(value);
  }
  return {stratum};
}

}  // namespace racebeam
