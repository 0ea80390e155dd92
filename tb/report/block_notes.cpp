// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/block_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "sc/block/block_machine.h"
#include "tb/base/version.h"
#include "tb/bench/block_bench.h"
#include "tb/judge/block_judge.h"
#include "tb/report/notes_markdown.h"

namespace racebeam {

namespace {

constexpr int Step = 2;                      // every second pixel of every second row
constexpr double Bound2 = 8, Bound16 = 0.5;  // percent

constexpr const char* Head = R"(<!-- made by `racebeam scene notes`, do not edit -->
# The scenes of the block renderer in numbers

racebeam {}: `{}`

Up to {} pictures spread evenly over each scene, at the tlm level with the renderer's own knobs{}. Counters are means of a picture:
clocks of all cores while they draw, a pixel; blocks cleared; groups of lanes met, roots and lit points a pixel; vectors too short for
a good unit vector, and roots of 8 and above. Every second pixel of every second row is compared with `geometry`, the same rules in
double precision, whose channels have 256 levels too: pixels off by more than 2 and by more than 16 in some channel. Roots are up to
6 % too long, and mirrors multiply that: it is meant that in one pass, without mirrors, at most {} % and {} % are off so far: the last
columns, by the worst picture. A ray that meets another sphere than it should is at an edge, or in a block that was cleared though a
small sphere is in it: `cull=corners` loses such.

| scene | pictures | spheres | clocks a pixel | most | cleared | groups | roots | lit | short | roots of 8 | RMSE | by more than 2 | by more than 16 | other sphere | one pass: by more than 2 | by more than 16 |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
)";

struct Drawn {
  block_counters counters;
  BlockErrors errors;
};

Drawn draw(const BlockProgram& program, const block_knobs& k, int picture) {
  const block_tables tables = tables_of(program, k, picture);
  block_machine machine(k);
  machine.draw(tables);
  LoadBar bar(k);
  const VgaFrame drawn =
      block_frame(picture, machine.picture(), machine.counters(), k, bar, {}).picture;
  return {machine.counters(), block_errors(tables, k, drawn, Step)};
}

double percent(std::uint64_t part, const BlockErrors& of) {
  return 100 * static_cast<double>(part) / static_cast<double>(of.all.pixels);
}

class NotedBlocks final : public NotedScene {
 public:
  NotedBlocks(const Show& show, const block_knobs& k)
      : show_(show), k_(k), program_(block_program_of(show_.tables())) {}

  void add(int picture) override {
    const Drawn drawn = draw(program_, k_, picture);
    ++pictures_;
    const block_counters& n = drawn.counters;
    most_ = std::max(most_, n.busy_clocks);
    sum_.busy_clocks += n.busy_clocks;
    sum_.cleared += n.cleared;
    sum_.groups += n.groups;
    sum_.roots += n.roots;
    sum_.shades[0] += std::accumulate(n.shades.begin(), n.shades.end(), std::uint64_t{0});
    sum_.small_vectors += n.small_vectors;
    sum_.root_out_of_range += n.root_out_of_range;
    errors_.all += drawn.errors.all;
    errors_.by_more_than_2 += drawn.errors.by_more_than_2;
    errors_.by_more_than_16 += drawn.errors.by_more_than_16;
    block_knobs one_pass = k_;
    one_pass.max_passes = 1;
    const BlockErrors e = draw(program_, one_pass, picture).errors;
    worst_2_ = std::max(worst_2_, percent(e.by_more_than_2, e));
    worst_16_ = std::max(worst_16_, percent(e.by_more_than_16, e));
  }

  std::string text() const override {
    const double pictures = pictures_, pixels = double(k_.columns()) * k_.rows();
    const auto mean = [&](std::uint64_t sum) { return static_cast<double>(sum) / pictures; };
    const auto a_pixel = [&](std::uint64_t sum) { return mean(sum) / pixels; };
    return fmt::format(
        "| {} | {} of {} | {} | {:.2f} | {:.2f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | "
        "{:.0f} | {:.2f} | {:.2f} % | {:.2f} % | {:.2f} % | {:.2f} % | {:.2f} % |\n",
        markdown_text(show_.name()), pictures_, show_.frames(), program_.bodies.size(),
        a_pixel(sum_.busy_clocks), static_cast<double>(most_) / pixels, mean(sum_.cleared),
        a_pixel(sum_.groups), a_pixel(sum_.roots), a_pixel(sum_.shades[0]),
        mean(sum_.small_vectors), mean(sum_.root_out_of_range), errors_.all.rmse(),
        percent(errors_.by_more_than_2, errors_), percent(errors_.by_more_than_16, errors_),
        percent(errors_.all.wrong_hits, errors_), worst_2_, worst_16_);
  }

  /// One golden tracer knows no causes.
  int unexplained() const override { return 0; }

 private:
  const Show show_;
  const block_knobs k_;
  const BlockProgram& program_;
  int pictures_ = 0;
  std::uint64_t most_ = 0;  // busy clocks of a picture
  block_counters sum_;      // all lit points in shades[0]
  BlockErrors errors_;
  double worst_2_ = 0, worst_16_ = 0;  // percent, in one pass
};

}  // namespace

std::string block_notes_head(const NotesCommand& command) {
  return fmt::format(Head, program_version(), notes_command(command), command.frames,
                     command.set.empty() ? "" : " but those set here", Bound2, Bound16);
}

std::unique_ptr<NotedScene> noted_blocks(const Show& show, const knob_values& k) {
  return std::make_unique<NotedBlocks>(show, k);
}

}  // namespace racebeam
