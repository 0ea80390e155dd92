// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/rung_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* Schema = "racebeam-sweep-plan";

// A worker takes some 10 ms to begin a block of work, and keeps what it has when that is done.
constexpr std::size_t FewFrames = 64, MostFrames = 256;
constexpr double MostSeconds = 5;

using Works = std::vector<const PlannedWork*>;

/// Work that shares its pictures: of one scene.
std::vector<Works> by_scene(const std::vector<PlannedWork>& work) {
  std::map<int, Works> scenes;
  for (const PlannedWork& one : work)
    if (!one.work.frames.empty()) scenes[one.work.scene].push_back(&one);
  std::vector<Works> all;
  for (auto& [scene, works] : scenes) all.push_back(std::move(works));
  return all;
}

/// Fills blocks one after the other, each with so much time or a bit more.
class Filler {
 public:
  Filler(double seconds, const FrameSeconds& cost) : seconds_(seconds), cost_(cost) {}

  void add(const PlannedWork& from, std::vector<int> frames) {
    const double cost = cost_(from.work);
    for (std::size_t begin = 0; begin < frames.size();) {
      if (blocks_.empty() || filled_ >= seconds_) {
        blocks_.emplace_back();
        filled_ = 0;
      }
      const double room = std::max(1.0, std::ceil((seconds_ - filled_) / cost));
      const std::size_t left = frames.size() - begin;
      const std::size_t taken = room < double(left) ? static_cast<std::size_t>(room) : left;
      PlannedWork part = from;
      part.work.number = ++number_;
      const auto first = frames.begin() + static_cast<std::ptrdiff_t>(begin);
      part.work.frames.assign(first, first + static_cast<std::ptrdiff_t>(taken));
      blocks_.back().push_back(std::move(part));
      filled_ += double(taken) * cost;
      begin += taken;
    }
  }
  std::vector<std::vector<PlannedWork>> blocks() { return std::move(blocks_); }

 private:
  const double seconds_;
  const FrameSeconds& cost_;
  std::vector<std::vector<PlannedWork>> blocks_;
  double filled_ = 0;
  int number_ = 0;
};

}  // namespace

std::vector<std::vector<PlannedWork>> divided(const std::vector<PlannedWork>& work, int blocks,
                                              const FrameSeconds& seconds) {
  double all = 0;
  for (const PlannedWork& one : work) all += double(one.work.frames.size()) * seconds(one.work);
  // A bit less, or what is lost in sums of real numbers made one more.
  const double share = all / std::max(1, blocks) * (1 - 1e-9);
  Filler filler(share, seconds);
  for (const Works& works : by_scene(work)) {
    std::set<int> frames;
    double cost = 0;
    for (const PlannedWork* one : works) {
      frames.insert(one->work.frames.begin(), one->work.frames.end());
      cost = std::max(cost, seconds(one->work));
    }
    const auto even = static_cast<std::size_t>(share / cost / double(works.size()));
    const auto most = static_cast<std::size_t>(std::max(1.0, MostSeconds / cost));
    const std::size_t step = std::min(std::clamp(even, FewFrames, MostFrames), most);
    const std::vector<int> order(frames.begin(), frames.end());
    for (std::size_t begin = 0; begin < order.size(); begin += step) {
      const int first = order[begin], last = order[std::min(begin + step, order.size()) - 1];
      for (const PlannedWork* one : works) {
        std::vector<int> part;
        for (const int frame : one->work.frames)
          if (frame >= first && frame <= last) part.push_back(frame);
        filler.add(*one, part);
      }
    }
  }
  return filler.blocks();
}

std::string rung_file(int rung) { return fmt::format("plan/{}.json", rung); }

void keep_rung(const std::string& folder, RungPlan& plan) {
  Json json = {{"schema", Schema},
               {"version", 1},
               {"rung", plan.rung},
               {"model", plan.model},
               {"blocks", Json::array()}};
  for (const std::vector<PlannedWork>& block : plan.blocks) {
    Json parts = Json::array();
    for (const PlannedWork& one : block)
      parts.push_back({{"setting", one.setting}, {"work", Json::parse(plan_text_of(one.work))}});
    json["blocks"].push_back(parts);
  }
  const std::string text = json.dump() + "\n";
  make_folder(folder + "/plan");
  write_text(folder + "/" + rung_file(plan.rung), text);
  plan.hash = text_hash(text);
}

RungPlan load_rung(const std::string& folder, int rung) {
  const std::string file = folder + "/" + rung_file(rung), text = whole_file(file);
  if (text.empty())
    throw UsageError(file +
                     " is not there; the folder must be one that this machine sees, too, and "
                     "racebeam sweep run --on slurm or --on hand writes the plan");
  try {
    const Json json = Json::parse(text);
    if (json.at("schema") != Schema || json.at("version") != 1 || json.at("rung") != rung)
      throw std::invalid_argument("another schema, version or rung");
    RungPlan plan{rung, json.at("model"), {}, text_hash(text)};
    for (const Json& block : json.at("blocks")) {
      plan.blocks.emplace_back();
      for (const Json& part : block)
        plan.blocks.back().push_back(
            {block_of_plan(part.at("work").dump()), part.at("setting").get<std::string>()});
    }
    return plan;
  } catch (const std::exception& error) {
    throw UsageError(file + " is no plan of this version: " + error.what());
  }
}

}  // namespace racebeam
