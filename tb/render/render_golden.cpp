// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/render_golden.h"

#include <zlib.h>

#include "sc/base/constants.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/progress.h"
#include "tb/judge/goldens.h"
#include "tb/judge/hit_maps.h"
#include "tb/render/frame_sequence.h"
#include "tb/render/render_files.h"
#include "tb/report/tracer_table.h"
#include "tb/show/demo_parts.h"

namespace racebeam {

namespace {

RenderedFrame render_frame(const RenderPlan& plan, int index) {
  RenderedFrame rendered;
  const int frame = rendered.number = plan.frames.number(index);
  VgaFrame& picture = rendered.picture;
  if (plan.hits) {
    show_hits(picture, hits_of(plan.show.engine()).golden(plan.show, plan.k, frame));
    if (!golden_of(plan.show.engine())) rendered.stats = counted(*plan.tracer, {});
    if (plan.pictures()) rendered.files.push_back(picture_file(plan, frame, picture));
    return rendered;
  }
  if (const GoldenKind* const golden = golden_of(plan.show.engine())) {
    picture = golden->picture(plan.show.tables(), plan.k, frame);
    if (plan.pictures()) rendered.files.push_back(picture_file(plan, frame, picture));
    return rendered;
  }
  GoldenWork work;
  picture.colours = golden_picture(*plan.tracer, plan.show.golden_world(frame, plan.k),
                                   plan.show.golden_camera(frame, plan.k), &work);
  rendered.stats = counted(*plan.tracer, work);
  picture.image_crc = static_cast<std::uint32_t>(
      crc32(0, picture.colours.data(), static_cast<uInt>(picture.colours.size())));
  if (plan.pictures()) rendered.files.push_back(picture_file(plan, frame, picture));
  return rendered;
}

// Stretches of one colour in a picture: no chip gets by with fewer intervals.
int stretches(const VgaFrame& picture) {
  int count = 0;
  for (std::size_t at = 0; at < picture.pixels(); ++at)
    if (at % static_cast<std::size_t>(picture.width) == 0 ||
        picture.colour(at) != picture.colour(at - 1))
      ++count;
  return count;
}

// Renders the planned frames; ends early when interrupted.
void render_frames(const RenderPlan& plan, FrameSequence& frames, RenderFiles& files,
                   GoldenFrames& report) {
  Progress progress(plan.frames.count());
  progress.draw(0, 0);
  if (!plan.json) print(tracer_header(report.tables()));
  for (int i = 0; i < plan.frames.count() && !interrupted(); ++i) {
    const std::optional<RenderedFrame> frame = frames.next();
    if (!frame) break;
    const std::string part = plan.show.part(frame->number);
    files.add(*frame, part);
    report.add(frame->number, part, frame->stats, frame->picture, plan.crc);
    progress.clear();
    if (!plan.json)
      print(tracer_row(report.tables(), frame->number, part, frame->stats,
                       stretches(frame->picture), frame->picture));
    progress.draw(i + 1, 0);
  }
  progress.clear();
}

}  // namespace

int render_golden(const RenderPlan& plan) {
  RenderFiles files(plan, plan.manifest());
  const bool one = golden_of(plan.show.engine());  // that counts nothing
  GoldenFrames report(plan.show.name(), *plan.tracer,
                      one ? GoldenTables{} : golden_tables(*plan.tracer), plan.k);
  FrameSequence frames(plan.jobs, plan.frames.count(), [&]() -> FrameSequence::Render {
    return [&](int index) { return render_frame(plan, index); };
  });
  files.run([&] { render_frames(plan, frames, files, report); }, nullptr,
            [&] { return report.text(); });
  if (plan.json) print(report.text());
  else if (report.frames() > 1) print(tracer_total(report));
  if (!plan.json) print(tracer_summary(report));
  const bool whole = report.frames() == plan.frames.count();
  tell((whole ? "wrote " : "stopped early; kept ") + files.summary());
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
