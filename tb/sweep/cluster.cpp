// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/cluster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

constexpr int Tries = 3;                       // of a block
constexpr double BlockSeconds = 90;            // a task costs Slurm a second or so
constexpr int FewestMinutes = 10, Slower = 5;  // that a task may take: another machine, and loaded
// How often results are looked at, and the queue: seldom, unless something has just begun, or is
// missing.
constexpr seconds Reading(2), Asking(30), AskingAgain(4);
constexpr std::size_t LastWords = 4096;  // bytes of a log

/// Of the jobs of a plan, and of no other one.
std::string job_name(const std::string& sweep, const RungPlan& plan) {
  std::string name;
  for (const char c : sweep.substr(0, 40))
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return fmt::format("racebeam-{}-{}-{}", name, plan.rung, plan.hash.substr(0, 8));
}

std::string end_of(const std::string& file) {
  const std::string text = whole_file(file);
  return text.size() <= LastWords ? text : text.substr(text.size() - LastWords);
}

}  // namespace

Cluster::Cluster(const ClusterOptions& options, const SweepPlan& plan, const SweepFolder& folder,
                 Store& store, ForkServer& server)
    : options_(options), plan_(plan), folder_(folder), store_(store), server_(server) {
  if (options.slurm) slurm_.emplace();
}

bool Cluster::run(std::list<Block> blocks, BlockRunner::Owner& owner) try {
  left_ = false;
  blocks.remove_if([](const Block& block) { return block.frames.empty(); });
  return blocks.empty() || bring(std::move(blocks), owner);
} catch (const Interrupted&) {
  return false;
}

bool Cluster::bring(std::list<Block> blocks, BlockRunner::Owner& owner) {
  if (const auto open = open_rung()) {
    if (open->covers(blocks)) return finish(*open, owner);
    open->collect(owner);  // the sweep has changed
    open->keep(store_.notes, true);
    open->remove_settled(blocks);
    if (blocks.empty()) return true;
  }
  const auto rung = new_rung(blocks);
  return finish(*rung, owner);
}

std::unique_ptr<ClusterRung> Cluster::open_rung() const {
  const KeptRung kept = kept_rung(store_.notes);
  std::error_code ignored;
  if (kept.ended || !std::filesystem::exists(folder_.file(rung_file(kept.rung)), ignored))
    return {};
  auto rung =
      std::make_unique<ClusterRung>(load_rung(folder_.path(), kept.rung), folder_.path(), plan_);
  if (rung->plan().model != model_hash(plan_.file.built->name)) return {};
  for (std::size_t i = 0; i < std::min(rung->tasks.size(), kept.tries.size()); ++i)
    rung->tasks[i].tries = kept.tries[i];
  return rung;
}

std::string Cluster::setting(const Block& block) const {
  return text_hash(plan_.points[static_cast<std::size_t>(block.point)]
                       .settings[static_cast<std::size_t>(block.scene)]);
}

std::unique_ptr<ClusterRung> Cluster::new_rung(const std::list<Block>& blocks) {
  const FrameSeconds cost = timed_frames(blocks, server_);
  if (interrupted()) throw Interrupted();
  std::vector<PlannedWork> work;
  double all = 0;
  for (const Block& block : blocks) {
    work.push_back({block, setting(block)});
    all += double(block.frames.size()) * cost(block);
  }
  const int most = slurm_ ? slurm_->largest_array() : 1'000'000;
  const int wanted =
      options_.tasks > 0 ? options_.tasks : static_cast<int>(std::lround(all / BlockSeconds));
  RungPlan plan{kept_rung(store_.notes).rung + 1, model_hash(plan_.file.built->name),
                divided(work, std::clamp(wanted, 1, most), cost)};
  keep_rung(folder_.path(), plan);
  const double each = all / double(plan.blocks.size());
  auto rung = std::make_unique<ClusterRung>(std::move(plan), folder_.path(), plan_);
  rung->minutes = std::max(FewestMinutes, static_cast<int>(std::ceil(Slower * each / 60)));
  rung->keep(store_.notes, false);
  tell(fmt::format("{}: {} of some {:.0f} s", folder_.file(rung_file(rung->plan().rung)),
                   counted(rung->blocks(), "block"), std::max(1.0, each)));
  return rung;
}

bool Cluster::finish(ClusterRung& rung, BlockRunner::Owner& owner) {
  Clock::time_point ask{};
  for (seconds pause = Reading;;) {
    // The queue first: what has left it before has written its lines before.
    std::optional<States> queue;
    if (slurm_ && Clock::now() >= ask) queue = states(rung);
    rung.collect(owner);
    if (rung.open().empty()) {
      rung.keep(store_.notes, true);
      return true;
    }
    if (queue) look_after(rung, *queue, owner);
    if (!slurm_ || !options_.wait) return leave(rung);
    bool missing = false, cancelled = true;
    const std::vector<int> open = rung.open();
    for (const int block : open) {
      const ClusterRung::Task& task = rung.tasks[static_cast<std::size_t>(block)];
      missing |= task.missing > 0;
      cancelled &= task.cancelled;
    }
    if (cancelled && !open.empty()) {
      tell(fmt::format("{} cancelled: {}; the same command queues them again",
                       counted(open.size(), "block"), ranges_text(open)));
      return false;
    }
    if (queue) {
      pause = missing ? AskingAgain : std::min(2 * pause, Asking);
      ask = Clock::now() + pause;
    }
    for (const auto end = Clock::now() + Reading; Clock::now() < end;) {
      if (interrupted()) {
        tell(fmt::format("what is queued goes on; scancel --name={} ends it",
                         job_name(plan_.file.name, rung.plan())));
        return false;
      }
      owner.look();
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
}

bool Cluster::leave(const ClusterRung& rung) {
  const std::vector<int> open = rung.open();
  if (open.empty()) {
    rung.keep(store_.notes, true);
    return true;
  }
  left_ = true;
  tell(fmt::format("{} of {} done; the same command collects what is", rung.blocks() - open.size(),
                   counted(rung.blocks(), "block")));
  if (!slurm_)
    tell(fmt::format("the others are {}; for each, on any machine that sees {}: {}",
                     ranges_text(open), folder_.path(), worker_command(rung, "racebeam", "N")));
  return false;
}

std::optional<Cluster::States> Cluster::states(const ClusterRung& rung) {
  std::string why;
  const auto states = slurm_->states(job_name(plan_.file.name, rung.plan()), rung.blocks(), why);
  if (!states && !answered_)
    throw MissingTool("Slurm does not answer; without it: racebeam sweep run ... --jobs N; " + why);
  if (!states && !complained_) tell("Slurm does not answer, which is waited for; " + why);
  complained_ = !states;
  answered_ = true;
  return states;
}

void Cluster::look_after(ClusterRung& rung, const States& states, BlockRunner::Owner& owner) {
  std::vector<int> lost, given_up;
  for (const int block : rung.open()) {
    ClusterRung::Task& task = rung.tasks[static_cast<std::size_t>(block)];
    const auto at = states.find(block);
    if (at != states.end() && at->second == TaskState::Live) {
      task.missing = 0;
      task.cancelled = false;
      continue;
    }
    const bool cancelled = at != states.end() && at->second == TaskState::Cancelled;
    if (cancelled && rung.looked) {
      task.cancelled = true;
      continue;
    }
    if (cancelled) task.tries = 0;  // before this command
    // Its last lines may be on their way, from another machine: but not when we come.
    if (task.cancelled || (++task.missing < 2 && rung.looked)) continue;
    (task.tries < Tries ? lost : given_up).push_back(block);
  }
  rung.looked = true;
  for (const int block : given_up) give_up(rung, block, owner);
  if (!lost.empty()) submit(rung, lost);
}

void Cluster::submit(ClusterRung& rung, const std::vector<int>& blocks) {
  Slurm::Job job;
  job.name = job_name(plan_.file.name, rung.plan());
  job.tasks = blocks;
  make_folder(folder_.file("log"));
  for (const char c : folder_.file("log"))
    job.log += c == '%' ? std::string("%%") : std::string(1, c);
  job.log += fmt::format("/{}.%a.txt", rung.plan().rung);
  job.command =
      "exec " + worker_command(rung, shell_quoted(std::filesystem::read_symlink("/proc/self/exe")),
                               "$SLURM_ARRAY_TASK_ID");
  job.minutes = rung.minutes;
  job.options = options_.options;
  std::string why;
  const auto number = slurm_->submit(job, why);
  if (!number) {
    if (!accepted_) throw UsageError(why);
    tell(why + "; tried again");
    return;
  }
  accepted_ = true;
  for (const int block : blocks) {
    ClusterRung::Task& task = rung.tasks[static_cast<std::size_t>(block)];
    task.missing = 0;
    task.tries++;
  }
  rung.keep(store_.notes, false);
  tell(fmt::format("{} queued, Slurm job {}: {}", counted(blocks.size(), "block"), *number,
                   ranges_text(blocks)));
}

void Cluster::give_up(ClusterRung& rung, int block, BlockRunner::Owner& owner) {
  const std::string log = fmt::format("log/{}.{}.txt", rung.plan().rung, block);
  rung.fail(
      block,
      fmt::format("block {} was queued {} times and did not come back; see {}", block, Tries, log),
      end_of(folder_.file(log)), owner);
}

std::string Cluster::worker_command(const ClusterRung& rung, const std::string& program,
                                    const std::string& block) const {
  return fmt::format("{} sweep work {} --rung {} --block {}", program, shell_quoted(folder_.path()),
                     rung.plan().rung, block);
}

}  // namespace racebeam
