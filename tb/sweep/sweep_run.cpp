// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/sweep/cluster.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/figure_file.h"
#include "tb/sweep/front_search.h"
#include "tb/sweep/guard_frames.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/measurer.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/nsga2_library.h"
#include "tb/sweep/provenance.h"
#include "tb/sweep/repeats.h"
#include "tb/sweep/reuse.h"
#include "tb/sweep/schema.h"
#include "tb/sweep/sweep_changes.h"
#include "tb/sweep/sweep_dry_run.h"
#include "tb/sweep/sweep_kinds.h"
#include "tb/sweep/sweep_pictures.h"
#include "tb/sweep/sweep_progress.h"
#include "tb/sweep/sweep_silicon.h"
#include "tb/sweep/sweep_state.h"
#include "tb/sweep/sweep_summary.h"
#include "tb/sweep/sweep_timing.h"
#include "tb/sweep/worker.h"

namespace racebeam {

namespace {

/// What the last run of a folder has found: who asks the same again gets it without a look at all
/// frames.
struct Found {
  explicit Found(const SweepPlan& plan)
      : key(plan.key() + model_hash(plan.file.built->name) + "\n") {}

  const std::string key;

  static void forget(Store& store) { store.notes.put("found", ""); }
  void keep(Store& store, const std::string& text, bool failed) const {
    store.notes.put("found", key + (failed ? "failed\n" : "good\n") + text);
  }
  /// Says it once more; the exit code, if it was found.
  std::optional<int> say(const Store& store) const {
    const std::string found = store.notes.find("found");
    if (found.rfind(key, 0) != 0) return {};
    const std::size_t end = found.find('\n', key.size());
    print(found.substr(end + 1));
    return found.compare(key.size(), end - key.size(), "good") == 0 ? ExitGood : ExitDifference;
  }
};

/// A run in a folder that is taken.
class Sweep {
 public:
  Sweep(const SweepOptions& options, SweepPlan& plan, SweepFolder& folder, Store& store,
        std::int64_t model, ForkServer& server)
      : options_(options),
        plan_(plan),
        found_(plan),
        folder_(folder),
        store_(store),
        former_(store),
        model_(model),
        reused_(reuse_results(store_, model_, plan, options.reuse)),
        progress_(plan, folder),
        cluster_(cluster(options, plan, folder, store, server)),
        measurer_(
            plan, folder, store, model, server, options.jobs,
            [this] { progress_.look(measurer_, rung_); }, cluster_.get()),
        state_(plan, store, measurer_),
        silicon_(plan, &store, options.fresh),
        timing_(plan, store, options.fresh) {}

  int run() {
    Found::forget(store_);
    folder_.keep_sweep(plan_.text);
    keep_scenes(store_, plan_);
    if (!searches()) tell_lines(former_.change_to(plan_));
    tell_lines(scenes_text(older_scenes(store_, model_)));
    tell(plan_text(plan_, there()) + silicon_.plan_text());
    if (reused_ > 0) tell(fmt::format("{} frames taken over", grouped(reused_)));
    const std::int64_t id = store_.runs.begin(this_run(options_.command, options_.jobs));
    const bool whole = measure();
    store_.runs.end(id, cpu_seconds());
    const bool left = !whole && cluster_ && cluster_->left();
    if (left) progress_.leave(measurer_, rung_);
    else progress_.end(measurer_, rung_, whole);
    if (!measurer_.failure(0).empty()) {
      tell("the base point cannot be measured, and nothing compared with it: " +
           measurer_.failure(0));
      return ExitDifference;
    }
    if (left) return ExitGood;
    if (!whole) {
      tell(fmt::format("interrupted; {} frames are kept; the same command goes on",
                       grouped(store_.frames.count(model_))));
      return ExitInterrupted;
    }
    measurer_.forget_failures();
    store_.stopped.replace(model_, state_.stops());
    keep_exact(store_, model_, state_.exact());
    folder_.keep_figures(figures_csv(plan_, measurer_, state_, rung_));
    const std::string text = summary_text(plan_, measurer_, state_, rung_) + timing_.text();
    print(text);
    if (!silicon_.absent() && !timing_.absent()) found_.keep(store_, text, measurer_.failed() > 0);
    return measurer_.failed() ? ExitDifference : ExitGood;
  }

 private:
  static std::unique_ptr<Cluster> cluster(const SweepOptions& options, const SweepPlan& plan,
                                          const SweepFolder& folder, Store& store,
                                          ForkServer& server) {
    if (options.on == "local") return {};
    return std::make_unique<Cluster>(
        ClusterOptions{options.on == "slurm", options.slurm, options.tasks, options.wait}, plan,
        folder, store, server);
  }

  static void tell_lines(const std::string& text) {
    for (const std::string& line : lines_of(text)) tell(line);
  }

  int last_rung() const {
    int most = 0;
    for (std::size_t scene = 0; scene < plan_.scenes.size(); ++scene)
      most = std::max(most, plan_.sample(scene));
    return most;
  }

  /// Frames of the sample that need not be measured.
  int there() const {
    const std::vector<Want> all = wants(last_rung());
    std::size_t frames = 0;
    for (const Want& want : all) frames += want.frames.size();
    return static_cast<int>(frames) - measurer_.missing(all);
  }

  /// The first frames of each scene for the points that go on.
  std::vector<Want> wants(int frames) const {
    std::vector<Want> all;
    for (const int point : state_.running())
      for (int scene = 0; scene < static_cast<int>(plan_.scenes.size()); ++scene) {
        const std::vector<int>& order = plan_.scenes[static_cast<std::size_t>(scene)].order;
        const auto count = std::min(order.size(), static_cast<std::size_t>(frames));
        all.push_back({point, scene, {order.begin(), order.begin() + std::ptrdiff_t(count)}});
      }
    return all;
  }

  bool measure() {
    if (!repeats_as_stored(plan_, store_, model_, measurer_)) return false;
    give_model_silicon();
    silicon_.measure(state_, measurer_, options_.jobs);
    if (plan_.file.measure.timing == SweepTiming::All) map_chips_of(state_.running());
    if (!(searches() ? search() : race())) return false;
    const int most = std::max(plan_.file.frames.most, last_rung());
    while (rung_ < most && state_.wide(rung_))
      if (!measure_rung(std::min(2 * rung_, most))) return false;
    if (!guard()) return false;
    if (plan_.file.measure.timing == SweepTiming::Front) map_chips_of(front());
    return keep_pictures(plan_, folder_, measurer_, state_);
  }

  /// What needs no tool.
  void give_model_silicon() {
    for (; described_ < static_cast<int>(plan_.points.size()); ++described_) {
      const int point = described_;
      const silicon made = sweep_kind(*plan_.file.built)
                               .made_of(plan_.points[static_cast<std::size_t>(point)].k.front(),
                                        plan_.scenes.front().show.tables());
      const auto set = [&](const char* figure, std::uint64_t value) {
        state_.set_exact(point, figure, static_cast<double>(value));
      };
      if (made.register_bits > 0) set("register_bits", made.register_bits);
      set("memory_bits", made.bits(memory_row::Working));
      set("partial_products", made.partial_products());
    }
  }

  void map_chips_of(const std::vector<int>& points) {
    timing_.measure(points, state_, measurer_, options_.jobs);
  }

  /// With the base; without goals all points.
  std::vector<int> front() const {
    if (plan_.file.goals.empty()) return state_.running();
    const SweepState::Verdicts all = state_.judge(rung_);
    std::vector<int> points;
    for (std::size_t i = 0; i < all.points.size(); ++i)
      if (all.points[i] == 0 || all.verdicts[i].standing == Verdict::Front)
        points.push_back(all.points[i]);
    return points;
  }

  bool race() {
    const bool races = plan_.file.search.races() && !plan_.file.goals.empty();
    for (const int frames : races ? rungs(last_rung()) : std::vector<int>{last_rung()}) {
      if (!measure_rung(frames)) return false;
      if (races) state_.race(frames);
    }
    return true;
  }

  bool searches() const { return plan_.file.search.adapts(); }

  bool search() try {
    const int frames = last_rung();
    const auto measure = [this, frames] {
      take_in_points();
      if (!measure_rung(frames)) throw Interrupted();
    };
    const auto readings = [this, frames](int point) {
      return measurer_.failure(point).empty() ? state_.read_goals(point, frames)
                                              : std::vector<Reading>();
    };
    tell(search_front(plan_, {measure, readings}));
    tell_lines(former_.change_to(plan_));
    return true;
  } catch (const Interrupted&) {
    return false;
  }

  void take_in_points() {
    measurer_.take_in_points();
    state_.take_in_points();
    for (; asked_ < plan_.points.size(); ++asked_)
      if (const std::string& why = plan_.points[asked_].objection; !why.empty())
        measurer_.refuse(static_cast<int>(asked_), why);
    give_model_silicon();
    silicon_.measure(state_, measurer_, options_.jobs);
    if (plan_.file.measure.timing == SweepTiming::All) map_chips_of(state_.running());
  }

  bool measure_rung(int frames) {
    rung_ = frames;
    return measurer_.measure(wants(frames)) && measurer_.failure(0).empty();
  }

  bool guard() {
    if (plan_.file.frames.guard == 0) return true;
    std::vector<Want> all;
    for (int scene = 0; scene < static_cast<int>(plan_.scenes.size()); ++scene) {
      const std::vector<int>& order = plan_.scenes[static_cast<std::size_t>(scene)].order;
      if (rung_ >= static_cast<int>(order.size())) continue;  // all are there
      if (!measurer_.scan(scene)) return false;
      const std::vector<int> worst =
          worst_frames(store_.scans.read(measurer_.key(0, scene)), plan_.file.frames.guard);
      for (const int point : state_.running()) all.push_back({point, scene, worst, true});
    }
    return measurer_.measure(all);
  }

  const SweepOptions& options_;
  SweepPlan& plan_;
  const Found found_;  // of the plan as it is before a search
  SweepFolder& folder_;
  Store& store_;
  const FormerPoints former_;
  const std::int64_t model_, reused_;
  int rung_ = 0;
  std::size_t asked_ = 0;  // points that a search has taken in
  int described_ = 0;      // points that have what needs no tool
  SweepProgress progress_;
  const std::unique_ptr<Cluster> cluster_;
  Measurer measurer_;
  SweepState state_;
  SweepSilicon silicon_;
  SweepTimings timing_;
};

}  // namespace

int run_sweep(const SweepOptions& options) {
  if (options.on == "slurm") Slurm();  // before anything is written
  ForkServer server(work_on);          // while this process is small
  SweepPlan plan = plan_sweep(options.file, options.assignments);
  if (plan.file.search.adapts()) nsga2_library();  // or say what is missing before anything is done
  if (options.dry_run) {
    print(dry_run_text(plan, options.folder, server, options.jobs));
    return ExitGood;
  }
  SweepFolder folder(options.folder, Access::Write);
  catch_interrupts();
  Store store(folder.store(), Access::Write);
  Transaction opening(store.database());  // a store that proves to be damaged stays as it was
  const std::int64_t model = open_model(store, plan, folder.path(), options.fresh);
  if (!options.fresh && !is_new_program(store, model))
    if (const std::optional<int> known = Found(plan).say(store)) return *known;
  Sweep sweep(options, plan, folder, store, model, server);
  opening.commit();
  return sweep.run();
}

}  // namespace racebeam
