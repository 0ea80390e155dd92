// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/sphere_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tb/base/version.h"
#include "tb/bench/sphere_bench.h"
#include "tb/host/sphere_picture.h"
#include "tb/judge/sphere_judge.h"
#include "tb/report/notes_markdown.h"

namespace racebeam {

namespace {

constexpr int Step = 2;  // every second pixel of every second row
constexpr double Bound = 0.01, BoundWithPlanes = 0.015;

constexpr const char* Head = R"(<!-- made by `racebeam scene notes`, do not edit -->
# The scenes of spheres in numbers

racebeam {}: `{}`

Up to {} pictures spread evenly over each scene, by the chip's core with its own knobs{}. Modes are those of the pictures drawn:
rays a pixel, reflections, planes or none. Counters are means of a picture, overflows their sum. Every second pixel of every
second row is compared with `geometry`, the same rules in double precision. It is meant that at most {} % of a picture with one
ray a pixel are off by more than one level of a colour, {} % with planes; floors without their checkerboards, whose squares may be
smaller than a pixel: the last two columns, by the worst picture. Mirrors that see each other and several rays a pixel are off in
more: a direction has 12 bits behind the point.

| scene | pictures | spheres | planes | modes | clocks a pixel, mean | most | primary rays | reflected | shadow | overflows | pixels differ | by more than a level | without checkerboards | meant |
|---|--:|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
)";

/// The same floors without squares.
SphereProgram unchecked(SphereProgram program) {
  for (plane_row& plane : program.planes) plane.checker = 0;
  return program;
}

bool has_checkerboards(const SphereProgram& program) {
  return std::any_of(program.planes.begin(), program.planes.end(),
                     [](const plane_row& plane) { return plane.checker != 0; });
}

struct Drawn {
  sphere_counters counters;
  PictureErrors errors;
  std::size_t pixels;
};

Drawn draw(const SphereProgram& program, const sphere_knobs& k, int picture) {
  const auto core = core_before(program, k, picture);
  const bool narrow = program.inputs_before(picture).narrow_q;
  core->draw(program.board_in(picture));
  const PackedPicture drawn = sphere_picture(picture, core->picture(), narrow, k, {});
  return {core->counters(), sphere_golden_errors(&program, k, picture, drawn, Step),
          drawn.pixels()};
}

double share_by_more(const PictureErrors& e) {
  return static_cast<double>(e.by_more) / static_cast<double>(e.pixels);
}

class NotedSpheres final : public NotedScene {
 public:
  NotedSpheres(const Show& show, const knob_values& k)
      : show_(show),
        k_(sphere_knobs(k).resolved()),
        program_(sphere_program_of(show_.tables())),
        unchecked_(unchecked(program_)) {}

  void add(int picture) override {
    const sphere_inputs_core in = program_.inputs_before(picture);
    const Drawn drawn = draw(program_, k_, picture);
    const double clocks =
        static_cast<double>(drawn.counters.clocks) / static_cast<double>(drawn.pixels);
    ++pictures_;
    clocks_ += clocks;
    most_ = std::max(most_, clocks);
    primary_ += drawn.counters.primary_rays;
    reflected_ += drawn.counters.reflected_rays;
    shadow_ += drawn.counters.shadow_rays;
    overflows_ += drawn.counters.overflows;
    errors_ += drawn.errors;
    modes_.insert(fmt::format("{}/{}/{}", last_sub(in.alias_q) + 1, int{in.max_reflections_q},
                              in.planes_q ? "planes" : "none"));
    const bool squares = in.planes_q && has_checkerboards(program_);
    const double off = share_by_more(squares ? draw(unchecked_, k_, picture).errors : drawn.errors);
    const double bound = in.planes_q ? BoundWithPlanes : Bound;
    if (pictures_ > 1 && off / bound <= off_ / bound_) return;
    off_ = off;
    bound_ = bound;
  }

  std::string text() const override {
    std::string modes;
    for (const std::string& mode : modes_) modes += (modes.empty() ? "" : ", ") + mode;
    const auto mean = [&](std::uint64_t sum) {
      return static_cast<double>(sum) / static_cast<double>(pictures_);
    };
    const auto percent = [&](std::uint64_t part) {
      return 100 * static_cast<double>(part) / static_cast<double>(errors_.pixels);
    };
    return fmt::format(
        "| {} | {} of {} | {} | {} | {} | {:.1f} | {:.1f} | {:.0f} | {:.0f} | {:.0f} | {} | {:.2f} "
        "% | {:.2f} % | {:.2f} % | {:.1f} % |\n",
        markdown_text(show_.name()), pictures_, show_.frames(), program_.moving.size(),
        program_.planes.size(), modes, mean_clocks(), most_, mean(primary_), mean(reflected_),
        mean(shadow_), overflows_, percent(errors_.differing), percent(errors_.by_more), 100 * off_,
        100 * bound_);
  }

  /// One golden tracer knows no causes.
  int unexplained() const override { return 0; }

 private:
  double mean_clocks() const { return clocks_ / pictures_; }

  const Show show_;
  const sphere_knobs k_;
  const SphereProgram& program_;
  const SphereProgram unchecked_;
  int pictures_ = 0;
  double clocks_ = 0, most_ = 0;  // a pixel
  std::uint64_t primary_ = 0, reflected_ = 0, shadow_ = 0, overflows_ = 0;
  PictureErrors errors_;
  std::set<std::string> modes_;
  double off_ = 0, bound_ = Bound;  // of the worst picture by its bound
};

}  // namespace

std::string sphere_notes_head(const NotesCommand& command) {
  return fmt::format(Head, program_version(), notes_command(command), command.frames,
                     command.set.empty() ? "" : " but those set here", 100 * Bound,
                     100 * BoundWithPlanes);
}

std::unique_ptr<NotedScene> noted_spheres(const Show& show, const knob_values& k) {
  return std::make_unique<NotedSpheres>(show, k);
}

}  // namespace racebeam
