// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/worker.h"

#include <unistd.h>

#include <algorithm>
#include <memory>

#include "tb/base/errors.h"
#include "tb/bench/benches.h"
#include "tb/show/open_show.h"
#include "tb/sweep/block.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/fork_server.h"
#include "tb/sweep/packed.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

/// Answers one block.
class Worker {
 public:
  Worker(Block block, int file)
      : block_(std::move(block)),
        file_(file),
        show_(open_show(block_.scene_name)),
        judge_(sweep_kind(show_.engine()).judge(show_, block_)),
        bench_(bench_of(show_.engine())
                   .make(show_.engine().levels.front(),
                         {show_.engine(), block_.k, show_.tables(), show_.frames()}, {})) {
    if (show_.hash() != block_.scene_hash)
      throw UsageError("the scene " + block_.scene_name +
                       " has changed since the sweep began; run the same command again");
  }

  void answer_all() {
    for (const int frame : block_.frames) say(answer_line(answer(frame)));
    say(done_line(block_.number));
  }

 private:
  Answer answer(int frame) {
    bench_->seek(frame);
    const ChipBench::Frame rendered = bench_->render();
    Answer answer;
    answer.block = block_.number;
    FrameRow& row = answer.frame.row;
    row.frame = frame;
    row.guard = block_.guard;
    if (block_.pictures) answer.picture = packed_picture(rendered.picture);
    else if (block_.scan) row.values = scanned(*rendered.stats);
    else measure(rendered, answer);
    row.digest = frame_digest(frame, row.values);
    return answer;
  }

  std::vector<std::int64_t> scanned(const frame_counts& stats) const {
    const std::vector<std::int64_t> values = column_values(show_.engine(), stats, {}, {});
    const std::vector<std::string> columns = sweep_columns(show_.engine());
    const auto value = [&](const char* column) {
      const auto at = std::find(columns.begin(), columns.end(), column);
      return values.at(static_cast<std::size_t>(at - columns.begin()));
    };
    const auto& worst = sweep_kind(show_.engine()).worst;
    return {value(worst[0]), value(worst[1])};
  }

  void measure(const ChipBench::Frame& rendered, Answer& answer) {
    const auto at = block_.kept.find(rendered.number);
    const KeptPictures kept = at == block_.kept.end() ? KeptPictures() : at->second;
    answer.frame.row.values =
        column_values(show_.engine(), *rendered.stats, judge_->errors(rendered, kept, answer),
                      rendered.picture.colours);
    const std::vector<histogram_info>& histograms = show_.engine().histograms;
    for (std::size_t i = 0; i < histograms.size(); ++i) {
      const auto& bins = rendered.stats->histograms[i];
      answer.frame.histograms[histograms[i].name] = {bins.begin(), bins.end()};
    }
  }

  void say(const std::string& line) const {
    if (!send_all(file_, line)) _exit(0);  // nobody listens any more
  }

  const Block block_;
  const int file_;
  const Show show_;
  const std::unique_ptr<FrameJudge> judge_;
  const std::unique_ptr<ChipBench> bench_;
};

}  // namespace

void work_on(const std::string& request, int file) {
  dup2(file, STDERR_FILENO);
  dup2(file, STDOUT_FILENO);
  int number = 0;
  try {
    const Block block = block_of(request);
    number = block.number;
    Worker(block, file).answer_all();
  } catch (const std::exception& error) {
    send_all(file, error_line(number, error.what()));
  }
}

}  // namespace racebeam
