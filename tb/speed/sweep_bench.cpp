// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/sweep_bench.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "tb/base/output_file.h"

namespace racebeam {

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

std::string SweepBench::file_of(const std::string& text) const {
  const std::string file = work_.path() + "/sweep.toml";
  write_text(file, text);
  return file;
}

ProgramRun SweepBench::run(const std::string& text, const std::string& folder, int jobs) const {
  return run_program({"sweep", "run", file_of(text), "-o", work_.path() + "/" + folder, "--jobs",
                      std::to_string(jobs)});
}

ProgramRun SweepBench::run_anew(const std::string& text, const std::string& folder,
                                int jobs) const {
  std::filesystem::remove_all(work_.path() + "/" + folder);
  return run(text, folder, jobs);
}

void SweepBench::copy(const std::string& from, const std::string& to) const {
  namespace fs = std::filesystem;
  fs::remove_all(work_.path() + "/" + to);
  fs::copy(work_.path() + "/" + from, work_.path() + "/" + to, fs::copy_options::recursive);
}

SweepPlan SweepBench::plan(const std::string& text) const { return plan_sweep(file_of(text), {}); }

std::string SweepBench::store_of(const std::string& folder) const {
  return work_.path() + "/" + folder + "/sweep.sqlite";
}

void SweepBench::fill(const std::string& text, const std::string& folder) const {
  const SweepPlan plan = this->plan(text);
  Store store(store_of(folder), Access::Write);
  std::vector<StoredPoint> points;
  for (const PlannedPoint& point : plan.points)
    points.push_back({point.settings.front(), point.point.name});
  const std::vector<std::int64_t> ids = store.points(points);
  const std::int64_t model = store.models().front().id, scene = store.scenes().front().id;
  std::vector<MeasuredFrame> frames;
  for (FrameRow& row : store.frames.read({model, scene, ids.front()}))
    frames.push_back({std::move(row), {}, {}});
  for (std::size_t i = 1; i < ids.size(); ++i) store.frames.put({model, scene, ids[i]}, frames);
}

std::int64_t SweepBench::frames_raced(const std::string& text, const std::string& folder,
                                      int sample) const {
  const SweepPlan plan = this->plan(text);
  Store store(store_of(folder), Access::Read);
  auto frames = static_cast<std::int64_t>(plan.points.size()) * sample;
  for (const StoppedPoint& one : store.stopped.all(store.models().front().id))
    frames -= std::max(0, sample - one.frames);
  return frames;
}

ProgramRun SweepBench::render(const std::string& text, int sample,
                              const std::string& setting) const {
  const std::vector<int> order = plan(text).scenes.front().order;
  std::vector<int> frames(order.begin(), order.begin() + sample);
  std::sort(frames.begin(), frames.end());
  return run_program({"render", "demo", "--at", fmt::format("{}", fmt::join(frames, ",")), "--set",
                      setting, "--stats", "/dev/null"});
}

}  // namespace racebeam
