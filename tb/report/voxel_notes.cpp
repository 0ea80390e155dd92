// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/voxel_notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/base/version.h"
#include "tb/bench/voxel_bench.h"
#include "tb/host/voxel_player.h"
#include "tb/judge/voxel_judge.h"
#include "tb/report/notes_markdown.h"

namespace racebeam {

namespace {

constexpr int Step = 4;  // every fourth pixel of every fourth row

constexpr const char* Head = R"(<!-- made by `racebeam scene notes`, do not edit -->
# The scenes of the voxel tracer in numbers

racebeam {}: `{}`

Up to {} pictures spread evenly over each scene, at the tlm level with the tracer's own knobs{}. Of picture 0, millions of clocks in
which the octree was built; then means of a picture, a pixel: clocks, bits of occupancy looked at, voxels left, descents and samples;
pixels that show the sky, and that a limit stopped. Every fourth pixel of every fourth row is compared with `geometry`, which walks the
columns in double precision: columns that are more than one away, and the error of the picture in 256 levels a channel. Samples lie
a unit apart, so a thin edge between two of them is missed: more of them (`leaf_steps`) or `leaf=voxel` mend that.

| scene | pictures | world | voxel | levels | build | clocks a pixel | most | looks | moves | descents | samples | sky | stopped | other column | RMSE |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
)";

class NotedVoxels final : public NotedScene {
 public:
  NotedVoxels(const Show& show, const voxel_knobs& k)
      : show_(show), k_(k), player_(voxel_program_of(show_.tables()), k) {
    player_.draw();
    build_ = player_.machine().counters().build_clocks;
  }

  void add(int picture) override {
    player_.seek(picture);
    player_.draw();
    const voxel_counters& n = player_.machine().counters();
    ++pictures_;
    clocks_ += n.clocks;
    most_ = std::max(most_, n.clocks);
    looks_ += n.walked.fetches();
    moves_ += n.walked.moves;
    descents_ += n.walked.descents;
    samples_ += n.walked.samples;
    sky_ += n.ends[VoxelSky];
    stopped_ += n.ends[VoxelOuterLimit] + n.ends[VoxelInnerLimit];
    const VgaFrame drawn = voxel_frame(picture, player_.machine().picture(), n, k_, {}).picture;
    errors_ += voxel_golden_errors(show_.tables(), k_, picture, drawn, Step);
  }

  std::string text() const override {
    const double pixels = double(pictures_) * k_.picture_width * k_.picture_height;
    const auto a_pixel = [&](std::uint64_t sum) { return static_cast<double>(sum) / pixels; };
    const auto percent = [&](std::uint64_t sum) { return 100 * a_pixel(sum); };
    return fmt::format(
        "| {} | {} of {} | {} x {} x {} | {} x {} x {} | {} | {:.2f} | {:.1f} | {:.1f} | {:.1f} | "
        "{:.1f} | {:.1f} | {:.1f} | {:.1f} % | {:.2f} % | {:.2f} % | {:.2f} |\n",
        markdown_text(show_.name()), pictures_, show_.frames(), k_.size_x, k_.size_y, k_.size_z,
        k_.voxel_x, k_.voxel_y, k_.voxel_z, voxel_levels(k_).count(),
        static_cast<double>(build_) / 1e6, a_pixel(clocks_), a_pixel(most_) * pictures_,
        a_pixel(looks_), a_pixel(moves_), a_pixel(descents_), a_pixel(samples_), percent(sky_),
        percent(stopped_),
        100 * static_cast<double>(errors_.wrong_hits) / static_cast<double>(errors_.pixels),
        errors_.rmse());
  }

  /// One golden tracer knows no causes.
  int unexplained() const override { return 0; }

 private:
  const Show show_;
  const voxel_knobs k_;
  VoxelPlayer player_;
  int pictures_ = 0;
  std::uint64_t build_ = 0, clocks_ = 0, most_ = 0, looks_ = 0, moves_ = 0, descents_ = 0;
  std::uint64_t samples_ = 0, sky_ = 0, stopped_ = 0;
  PictureErrors errors_;
};

}  // namespace

std::string voxel_notes_head(const NotesCommand& command) {
  return fmt::format(Head, program_version(), notes_command(command), command.frames,
                     command.set.empty() ? "" : " but those set here");
}

std::unique_ptr<NotedScene> noted_voxels(const Show& show, const knob_values& k) {
  return std::make_unique<NotedVoxels>(show, k);
}

}  // namespace racebeam
