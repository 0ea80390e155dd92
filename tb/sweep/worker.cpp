// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/worker.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>

#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/bench/tlm_bench.h"
#include "tb/judge/error_causes.h"
#include "tb/judge/reference_picture.h"
#include "tb/judge/visible_error.h"
#include "tb/show/open_show.h"
#include "tb/sweep/block.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/packed.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

constexpr std::size_t PictureSize = std::size_t(VisibleColumns) * VisibleRows;

std::string bytes_of(const GoldenPicture& picture) { return {picture.begin(), picture.end()}; }

/// Answers one block.
class Worker {
 public:
  Worker(Block block, int file)
      : block_(std::move(block)),
        file_(file),
        show_(open_show(block_.scene_name)),
        bench_({block_.k, true, false, false, show_.program()}) {
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
    bench_.seek(frame);
    const ChipBench::Frame rendered = bench_.render();
    const GoldenPicture& colours = rendered.picture.colours;
    Answer answer;
    answer.block = block_.number;
    FrameRow& row = answer.frame.row;
    row.frame = frame;
    row.guard = block_.guard;
    if (block_.pictures) answer.picture = packed(bytes_of(colours));
    else if (block_.scan) row.values = scanned(*rendered.stats);
    else measure(rendered, answer);
    row.digest = frame_digest(frame, row.values);
    return answer;
  }

  std::vector<std::int64_t> scanned(const frame_counts& stats) const {
    const std::vector<std::int64_t> values = column_values(stats, {}, {});
    const std::vector<std::string> columns = sweep_columns(show_.engine());
    const auto value = [&](const char* column) {
      const auto at = std::find(columns.begin(), columns.end(), column);
      return values.at(static_cast<std::size_t>(at - columns.begin()));
    };
    return {value("busy_clocks.max"), value("seen_starved_pixels")};
  }

  void measure(const ChipBench::Frame& rendered, Answer& answer) {
    const GoldenPicture& colours = rendered.picture.colours;
    const int frame = rendered.number;
    const GoldenPicture reference = reference_of(frame, colours, answer);
    const FrameErrors errors{golden_difference(colours, reference),
                             visible_difference(colours, reference)};
    answer.frame.row.values = column_values(*rendered.stats, errors, colours);
    const std::vector<histogram_info>& histograms = show_.engine().histograms;
    for (std::size_t i = 0; i < histograms.size(); ++i) {
      const auto& bins = rendered.stats->histograms[i];
      answer.frame.histograms[histograms[i].name] = {bins.begin(), bins.end()};
    }
    if (block_.causes) answer.frame.causes = causes_of(frame, reference);
  }

  GoldenPicture reference_of(int frame, const GoldenPicture& colours, Answer& answer) {
    if (block_.is_base && block_.reference == SweepReference::Base) {
      answer.reference = packed(bytes_of(colours));
      return colours;
    }
    if (const auto at = block_.references.find(frame); at != block_.references.end()) {
      const std::string bytes = unpacked(at->second, PictureSize);
      return {bytes.begin(), bytes.end()};
    }
    if (block_.reference == SweepReference::Base)
      throw std::runtime_error("the base's picture of frame " + std::to_string(frame) +
                               " is missing");
    const GoldenPicture made =
        ReferencePicture(show_, block_.reference, block_.k, block_.k).picture(frame);
    answer.reference = packed(bytes_of(made));
    return made;
  }

  std::map<std::string, std::int64_t> causes_of(int frame, const GoldenPicture& reference) const {
    const auto& names = error_causes(block_.reference);
    const std::vector<int> pixels =
        errors_by_cause(show_, frame, block_.k, block_.reference, reference);
    std::map<std::string, std::int64_t> causes;
    for (std::size_t i = 0; i < names.size(); ++i) causes[names[i].name] = pixels[i];
    return causes;
  }

  void say(const std::string& line) const {
    if (!write_all(file_, line)) _exit(0);  // nobody listens any more
  }

  const Block block_;
  const int file_;
  const Show show_;
  TlmBench bench_;
};

}  // namespace

void work_on(const std::string& request, int file) {
  signal(SIGPIPE, SIG_IGN);
  dup2(file, STDERR_FILENO);
  dup2(file, STDOUT_FILENO);
  int number = 0;
  try {
    const Block block = block_of(request);
    number = block.number;
    Worker(block, file).answer_all();
  } catch (const std::exception& error) {
    write_all(file, error_line(number, error.what()));
  }
}

}  // namespace racebeam
