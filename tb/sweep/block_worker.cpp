// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/block_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"
#include "tb/sweep/block_results.h"
#include "tb/sweep/block_runner.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/sweep_kinds.h"
#include "tb/sweep/worker.h"

namespace racebeam {

namespace {

/// Appends what is answered, and keeps pictures for the next point on the same frames.
class BlockWorker : public BlockRunner::Owner {
 public:
  BlockWorker(const std::string& folder, const RungPlan& plan, int block)
      : folder_(folder), plan_(plan), block_(block) {
    ResultReader(folder, plan, block).read([this](int, const PlannedWork& work, AnswerLine line) {
      if (line.kind == AnswerLine::Error) given_up_.insert(work.work.number);
      if (line.kind != AnswerLine::Frame) return;
      keep(work.work, line.answer);
      answered_[work.work.number].insert(line.answer.frame.row.frame);
    });
  }

  /// What nobody has answered.
  std::list<Block> left() {
    std::list<Block> work;
    for (const PlannedWork& one : plan_.blocks[static_cast<std::size_t>(block_)]) {
      if (given_up_.count(one.work.number)) continue;
      Block block = one.work;
      const std::set<int>& there = answered_[block.number];
      block.frames.erase(std::remove_if(block.frames.begin(), block.frames.end(),
                                        [&](int frame) { return there.count(frame) > 0; }),
                         block.frames.end());
      if (!block.frames.empty()) work.push_back(std::move(block));
    }
    return work;
  }
  bool failed() const { return !given_up_.empty(); }

  void prepare(Block& block) override {
    if (block.scan || block.pictures) return;
    const ReferenceKeys& keys = keys_of(block);
    for (const int frame : block.frames) {
      KeptPictures& kept = block.kept[frame];
      kept.reference = find(block, frame, keys.reference);
      kept.end = find(block, frame, keys.end);
      for (const std::string& link : keys.links) kept.links.push_back(find(block, frame, link));
    }
  }
  void take(const Block& block, const std::vector<Answer>& answers) override {
    std::string lines;
    for (const Answer& answer : answers) {
      lines += answer_line(answer);
      keep(block, answer);
    }
    append(lines);
  }
  void fail(const Block& block, const std::string& reason, const std::string& words) override {
    given_up_.insert(block.number);
    tell(reason);
    append(error_line(block.number, reason + (words.empty() ? "" : "\n" + words)));
  }
  void look() override {}

 private:
  using Name = std::tuple<std::string, int, std::string>;  // scene, frame, what

  const ReferenceKeys& keys_of(const Block& block) {
    auto at = keys_.find(block.number);
    if (at == keys_.end()) {
      if (!show_ || show_->hash() != block.scene_hash) show_.emplace(open_show(block.scene_name));
      at = keys_.emplace(block.number, sweep_kind(show_->engine()).judge(*show_, block)->keys())
               .first;
    }
    return at->second;
  }
  std::string find(const Block& block, int frame, const std::string& key) const {
    const auto at = pictures_.find({block.scene_hash, frame, key});
    return key.empty() || at == pictures_.end() ? "" : at->second;
  }
  void keep(const Block& block, const Answer& answer) {
    const KeptPictures& made = answer.made;
    if (made.reference.empty() && made.end.empty() && made.links.empty()) return;
    const ReferenceKeys& keys = keys_of(block);
    const auto put = [&](const std::string& key, const std::string& picture) {
      if (!picture.empty()) pictures_[{block.scene_hash, answer.frame.row.frame, key}] = picture;
    };
    put(keys.reference, made.reference);
    put(keys.end, made.end);
    for (std::size_t i = 0; i < std::min(keys.links.size(), made.links.size()); ++i)
      put(keys.links[i], made.links[i]);
  }
  // A worker that has nothing to say leaves no file.
  void append(const std::string& lines) {
    if (!file_) file_.emplace(folder_, plan_, block_);
    file_->append(lines);
  }

  const std::string folder_;
  const RungPlan& plan_;
  const int block_;
  std::optional<Show> show_;
  std::map<int, ReferenceKeys> keys_;
  std::map<Name, std::string> pictures_;
  std::map<int, std::set<int>> answered_;
  std::set<int> given_up_;
  std::optional<ResultFile> file_;
};

void expect_model(const RungPlan& plan, const std::string& folder) {
  if (engine_of_model(plan.model)) return;
  std::string own;
  for (const engine* one : engines())
    own += fmt::format("{}{} {}", own.empty() ? "" : ", ", one->name, model_hash(one->name));
  throw UsageError(
      fmt::format("{}/{} is for the model {}; this program has {}: all machines need "
                  "the same one",
                  folder, rung_file(plan.rung), plan.model, own));
}

}  // namespace

int work_on_block(const std::string& folder, int rung, int block) {
  ForkServer server(work_on);  // while this process is small
  catch_interrupts();
  const RungPlan plan = load_rung(folder, rung);
  expect_model(plan, folder);
  if (block < 0 || block >= static_cast<int>(plan.blocks.size()))
    throw UsageError(fmt::format("{}/{} has no block {}: there is 0..{}", folder, rung_file(rung),
                                 block, plan.blocks.size() - 1));
  BlockWorker worker(folder, plan, block);
  std::list<Block> left = worker.left();
  if (left.empty()) {
    tell(fmt::format("block {} is done already", block));
    return worker.failed() ? ExitDifference : ExitGood;
  }
  if (!BlockRunner(server, 1, worker).run(std::move(left))) return ExitInterrupted;
  return worker.failed() ? ExitDifference : ExitGood;
}

}  // namespace racebeam
