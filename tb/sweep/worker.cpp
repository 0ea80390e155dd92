// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/worker.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

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
    if (block_.causes) chain_.emplace(show_, block_.k, block_.reference);
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
    if (block_.pictures) answer.picture = packed_colours(colours);
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
    return {value("busy_clocks.max"), value("seen_starved_pixels")};
  }

  void measure(const ChipBench::Frame& rendered, Answer& answer) {
    const GoldenPicture& colours = rendered.picture.colours;
    const auto at = block_.kept.find(rendered.number);
    const KeptPictures kept = at == block_.kept.end() ? KeptPictures() : at->second;
    const GoldenPicture reference =
        reference_.made_with() == block_.k && block_.reference == SweepReference::Base
            ? own(colours, kept.reference, answer.made.reference)
            : made(reference_, rendered.number, kept.reference, answer.made.reference);
    const FrameErrors errors{golden_difference(colours, reference),
                             visible_difference(colours, reference)};
    answer.frame.row.values = column_values(show_.engine(), *rendered.stats, errors, colours);
    const std::vector<histogram_info>& histograms = show_.engine().histograms;
    for (std::size_t i = 0; i < histograms.size(); ++i) {
      const auto& bins = rendered.stats->histograms[i];
      answer.frame.histograms[histograms[i].name] = {bins.begin(), bins.end()};
    }
    if (block_.causes) put_causes(rendered, reference, kept, answer);
  }

  /// A picture that is not rendered.
  static GoldenPicture own(const GoldenPicture& colours, const std::string& kept,
                           std::string& packed_one) {
    if (kept.empty()) packed_one = packed_colours(colours);
    return colours;
  }

  /// As it is kept, or else made and packed.
  static GoldenPicture made(const ReferencePicture& reference, int frame, const std::string& kept,
                            std::string& packed_one) {
    if (!kept.empty()) return unpacked_colours(kept, PictureSize);
    GoldenPicture picture = reference.picture(frame);
    packed_one = packed_colours(picture);
    return picture;
  }

  void put_causes(const ChipBench::Frame& rendered, const GoldenPicture& reference,
                  const KeptPictures& kept, Answer& answer) const {
    const bool same = block_.reference != SweepReference::Base;
    const GoldenPicture end =
        same ? reference : made(chain_->end(), rendered.number, kept.end, answer.made.end);
    ErrorChain::Links links(chain_->keys().size());
    for (std::size_t i = 0; i < kept.links.size(); ++i)
      if (!kept.links[i].empty()) links.at(i) = unpacked(kept.links[i], PictureSize / 8);
    const ErrorChain::Links known = links;
    const std::vector<int> pixels =
        chain_->by_cause(rendered.number, rendered.picture.colours, end, links);
    for (std::size_t i = 0; i < links.size(); ++i)
      answer.made.links.push_back(known[i].empty() ? packed(links[i]) : "");
    const auto& names = error_causes(block_.reference);
    for (std::size_t i = 0; i < names.size(); ++i) answer.frame.causes[names[i].name] = pixels[i];
  }

  void say(const std::string& line) const {
    if (!write_all(file_, line)) _exit(0);  // nobody listens any more
  }

  const Block block_;
  const int file_;
  const Show show_;
  const ReferencePicture reference_{show_, block_.reference, block_.k, block_.base};
  std::optional<ErrorChain> chain_;
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
