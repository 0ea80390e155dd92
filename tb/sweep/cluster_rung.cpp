// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/cluster_rung.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "tb/base/console.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

constexpr const char* Note = "cluster";

}  // namespace

ClusterRung::ClusterRung(RungPlan plan, const std::string& folder, const SweepPlan& sweep)
    : tasks(plan.blocks.size()), plan_(std::move(plan)), reader_(folder, plan_) {
  std::map<std::pair<std::string, std::string>, std::pair<int, int>> there;
  for (std::size_t point = 0; point < sweep.points.size(); ++point)
    for (std::size_t scene = 0; scene < sweep.scenes.size(); ++scene)
      there.insert(
          {{sweep.scenes[scene].show.hash(), text_hash(sweep.points[point].settings[scene])},
           {static_cast<int>(point), static_cast<int>(scene)}});
  for (const std::vector<PlannedWork>& block : plan_.blocks)
    for (const PlannedWork& one : block) {
      Work& work = works_[one.work.number];
      work.as = one.work;
      const auto at = there.find({one.work.scene_hash, one.setting});
      work.wanted = at != there.end();
      if (work.wanted) std::tie(work.as.point, work.as.scene) = at->second;
    }
}

void ClusterRung::collect(BlockRunner::Owner& owner) {
  constexpr std::size_t AtOnce = 1000;  // answers, for the memory's sake
  Answers answers;
  std::size_t count = 0;
  reader_.read([&](int, const PlannedWork& planned, AnswerLine line) {
    Work& work = works_.at(planned.work.number);
    if (!work.wanted) return;
    if (line.kind == AnswerLine::Error) work.error = line.error;
    if (line.kind != AnswerLine::Frame) return;
    const FrameRow& row = line.answer.frame.row;
    const auto [at, is_new] = work.answered.emplace(row.frame, row.digest);
    if (!is_new && at->second == row.digest) return;  // done twice, and the same
    answers[planned.work.number].push_back(std::move(line.answer));
    if (++count % AtOnce == 0) hand_on(answers, owner);
  });
  hand_on(answers, owner);
  for (auto& [number, work] : works_) {
    if (!work.open() || work.error.empty()) continue;
    const std::size_t end = work.error.find('\n');
    work.failed = true;
    owner.fail(work.as, work.error.substr(0, end),
               end == std::string::npos ? "" : work.error.substr(end + 1));
  }
  for (const std::string& line : lines_of(reader_.refused()))
    if (told_.insert(line).second) tell(line);
}

void ClusterRung::hand_on(Answers& answers, BlockRunner::Owner& owner) {
  for (const auto& [number, some] : answers) owner.take(works_.at(number).as, some);
  answers.clear();
}

std::vector<int> ClusterRung::open() const {
  std::vector<int> blocks;
  for (int block = 0; block < this->blocks(); ++block) {
    const std::vector<PlannedWork>& all = plan_.blocks[static_cast<std::size_t>(block)];
    if (std::any_of(all.begin(), all.end(),
                    [this](const PlannedWork& one) { return works_.at(one.work.number).open(); }))
      blocks.push_back(block);
  }
  return blocks;
}

void ClusterRung::fail(int block, const std::string& reason, const std::string& words,
                       BlockRunner::Owner& owner) {
  for (const PlannedWork& one : plan_.blocks[static_cast<std::size_t>(block)]) {
    Work& work = works_.at(one.work.number);
    if (!work.open()) continue;
    work.failed = true;
    owner.fail(work.as, reason, words);
  }
}

ClusterRung::Key ClusterRung::key(const Block& block) {
  return {block.point, block.scene, block.guard, block.scan, block.causes};
}

bool ClusterRung::covers(const std::list<Block>& blocks) const {
  std::map<Key, std::set<int>> there;
  for (const auto& [number, work] : works_)
    if (work.wanted) there[key(work.as)].insert(work.as.frames.begin(), work.as.frames.end());
  return std::all_of(blocks.begin(), blocks.end(), [&](const Block& block) {
    const std::set<int>& frames = there[key(block)];
    return std::all_of(block.frames.begin(), block.frames.end(),
                       [&](int frame) { return frames.count(frame) > 0; });
  });
}

void ClusterRung::remove_settled(std::list<Block>& blocks) const {
  std::map<Key, std::set<int>> settled;
  for (const auto& [number, work] : works_) {
    if (!work.wanted) continue;
    std::set<int>& frames = settled[key(work.as)];
    if (work.failed) frames.insert(work.as.frames.begin(), work.as.frames.end());
    for (const auto& [frame, digest] : work.answered) frames.insert(frame);
  }
  for (Block& block : blocks) {
    const std::set<int>& gone = settled[key(block)];
    block.frames.erase(std::remove_if(block.frames.begin(), block.frames.end(),
                                      [&](int frame) { return gone.count(frame) > 0; }),
                       block.frames.end());
  }
  blocks.remove_if([](const Block& block) { return block.frames.empty(); });
}

void ClusterRung::keep(NoteTable& notes, bool ended) const {
  nlohmann::json tries = nlohmann::json::array();
  for (const Task& task : tasks) tries.push_back(task.tries);
  notes.put(Note, nlohmann::json{{"rung", plan_.rung}, {"ended", ended}, {"tries", tries}}.dump());
}

KeptRung kept_rung(const NoteTable& notes) {
  const std::string text = notes.find(Note);
  if (text.empty()) return {};
  const auto json = nlohmann::json::parse(text);
  return {json.at("rung"), json.at("ended"), json.at("tries").get<std::vector<int>>()};
}

namespace {

constexpr std::size_t TimedFrames = 8;

/// Keeps the pictures that were made, for a second time.
struct Timing : BlockRunner::Owner {
  explicit Timing(const std::map<int, KeptPictures>& pictures) : made(pictures) {}
  void prepare(Block& block) override { block.kept = made; }
  void take(const Block&, const std::vector<Answer>& answers) override {
    for (const Answer& answer : answers) made.emplace(answer.frame.row.frame, answer.made);
  }
  // The same work fails elsewhere, and is told then.
  void fail(const Block&, const std::string&, const std::string&) override {}
  void look() override {}

  std::map<int, KeptPictures> made;
};

}  // namespace

FrameSeconds timed_frames(const std::list<Block>& blocks, ForkServer& server) {
  using Clock = std::chrono::steady_clock;
  struct Seconds {
    double first = 0, more = 0;  // with pictures that have to be made, and without
    int points = 0;
  };
  std::map<int, Seconds> scenes;
  for (const Block& block : blocks) {
    Seconds& seconds = scenes[block.scene];
    if (seconds.points++ > 0) continue;
    Block some = block;
    some.frames.resize(std::min(TimedFrames, some.frames.size()));
    std::map<int, KeptPictures> made;
    for (double* const one : {&seconds.first, &seconds.more}) {
      Timing timing(made);
      const auto begin = Clock::now();
      BlockRunner(server, 1, timing).run({some});
      *one =
          std::chrono::duration<double>(Clock::now() - begin).count() / double(some.frames.size());
      made = std::move(timing.made);
    }
  }
  return [scenes](const Block& work) {
    const Seconds& seconds = scenes.at(work.scene);
    if (work.causes) return seconds.first;  // most of their pictures are the point's own
    return seconds.more + std::max(0.0, seconds.first - seconds.more) / seconds.points;
  };
}

}  // namespace racebeam
