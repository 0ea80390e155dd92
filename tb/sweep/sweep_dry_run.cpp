// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_dry_run.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "tb/base/counted.h"
#include "tb/sweep/block_runner.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/store.h"
#include "tb/sweep/sweep_folder.h"
#include "tb/sweep/sweep_silicon.h"
#include "tb/sweep/sweep_summary.h"

namespace racebeam {

namespace {

constexpr int Timed = 3;  // frames

/// How long frames take.
class Timing : public BlockRunner::Owner {
 public:
  void prepare(Block&) override {}
  void take(const Block&, const std::vector<Answer>& answers) override {
    for (const Answer& answer : answers) reference_bytes += answer.made.reference.size();
  }
  void fail(const Block&, const std::string& reason, const std::string&) override {
    throw std::runtime_error("the base point cannot be measured: " + reason);
  }
  void look() override {}

  std::size_t reference_bytes = 0;
};

std::string time_text(double seconds) {
  const auto whole = static_cast<long long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

// Frames of the sample that a folder has.
int frames_there(const SweepPlan& plan, const std::string& path) {
  const SweepFolder folder(path, Access::Read);
  std::error_code ignored;
  if (!std::filesystem::exists(folder.store(), ignored)) return 0;
  Store store(folder.store(), Access::Read);
  std::int64_t model = -1;
  for (const StoredModel& one : store.models())
    if (one.hash == model_hash(plan.file.built->name)) model = one.id;
  if (model < 0) return 0;
  const std::vector<StoredScene> scenes = store.scenes();
  const std::vector<StoredPoint> points = store.points();
  int count = 0;
  for (std::size_t at = 0; at < plan.scenes.size(); ++at)
    for (const StoredScene& scene : scenes) {
      if (scene.hash != plan.scenes[at].show.hash()) continue;
      const auto there = store.frames.there(model, scene.id);
      for (const StoredPoint& point : points)
        for (const PlannedPoint& planned : plan.points)
          if (planned.settings[at] == point.setting)
            if (const auto frames = there.find(point.id); frames != there.end())
              count += std::min(static_cast<int>(frames->second.size()), plan.sample(at));
    }
  return count;
}

}  // namespace

std::string dry_run_text(const SweepPlan& plan, const std::string& folder, ForkServer& server,
                         int jobs) {
  using Clock = std::chrono::steady_clock;
  const SweepScene& scene = plan.scenes.front();
  Block block;
  block.scene_name = scene.name;
  block.scene_hash = scene.show.hash();
  block.k = block.base = plan.points.front().k.front();
  block.frames.assign(
      scene.order.begin(),
      scene.order.begin() + std::min<std::ptrdiff_t>(Timed, std::ptrdiff_t(scene.order.size())));
  block.reference = plan.file.measure.reference;
  block.causes = plan.file.measure.causes;
  Timing timing;
  const auto time = [&] {
    const auto begin = Clock::now();
    BlockRunner(server, 1, timing).run({block});
    return std::chrono::duration<double>(Clock::now() - begin).count() /
           double(block.frames.size());
  };
  const double with_reference = time();
  const double reference_bytes = double(timing.reference_bytes) / double(block.frames.size());
  block.reference = SweepReference::Base;  // needs none
  const double alone = time();

  double frames = 0, first = 0;
  for (std::size_t at = 0; at < plan.scenes.size(); ++at) {
    frames += double(plan.points_at_most()) * plan.sample(at);
    first += plan.sample(at);
  }
  const int there = std::filesystem::exists(folder) ? frames_there(plan, folder) : 0;
  double seconds = (frames - there) * alone;
  if (there == 0) seconds += first * (with_reference - alone);
  if (plan.file.frames.guard > 0 && there == 0) seconds += plan.population() * alone;
  const double bytes = frames * 8.0 * double(sweep_columns(scene.show.engine()).size()) / 2 +
                       first * reference_bytes;
  return fmt::format("{}\nat most {} on {}, {:.0f} MB; nothing was written\n",
                     plan_text(plan, there) + SweepSilicon(plan, nullptr).plan_text(),
                     time_text(seconds / jobs), counted(jobs, "core"), std::max(1.0, bytes / 1e6));
}

}  // namespace racebeam
