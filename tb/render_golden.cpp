// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render_golden.h"

#include <fmt/format.h>
#include <zlib.h>

#include "tb/console.h"
#include "tb/demo_parts.h"
#include "tb/errors.h"
#include "tb/frame_sequence.h"
#include "tb/golden_json.h"
#include "tb/interrupt.h"
#include "tb/progress.h"
#include "tb/render_files.h"

namespace racebeam {

namespace {

constexpr const char* Row = "{:>5}  {:<32}{}\n";

RenderedFrame render_frame(const RenderPlan& plan, int index) {
  RenderedFrame rendered;
  const int frame = rendered.number = plan.frame(index);
  VgaFrame& picture = rendered.picture;
  picture.colours = golden_picture(*plan.tracer, plan.show.golden_world(frame, plan.k),
                                   plan.show.golden_camera(frame));
  if (plan.crc)
    picture.image_crc = static_cast<std::uint32_t>(
        crc32(0, picture.colours.data(), static_cast<uInt>(picture.colours.size())));
  if (!plan.folder.empty()) rendered.files.push_back(picture_file("frame", frame, picture.colours));
  return rendered;
}

std::string crc_column(const RenderPlan& plan, const VgaFrame& picture) {
  return plan.crc ? fmt::format(" {:08x}", picture.image_crc) : "";
}

}  // namespace

int render_golden(const RenderPlan& plan) {
  RenderFiles files(plan, plan.manifest());
  GoldenFrames report(plan.show.name(), golden_tracer_names()[static_cast<int>(*plan.tracer)],
                      plan.k);
  FrameSequence frames(plan.jobs, plan.frames, [&]() -> FrameSequence::Render {
    return [&](int index) { return render_frame(plan, index); };
  });
  Progress progress(plan.frames);
  progress.draw(0, 0);
  if (!plan.json) print(fmt::format(Row, "frame", "part", plan.crc ? " image" : ""));
  for (int i = 0; i < plan.frames && !interrupted(); ++i) {
    const std::optional<RenderedFrame> frame = frames.next();
    if (!frame) break;
    const std::string part = plan.show.part(frame->number);
    files.add(*frame, part);
    report.add(frame->number, part, frame->picture, plan.crc);
    progress.clear();
    if (!plan.json) print(fmt::format(Row, frame->number, part, crc_column(plan, frame->picture)));
    progress.draw(i + 1, 0);
  }
  files.finish(nullptr, report.text());
  if (plan.json) print(report.text());
  const bool whole = report.frames() == plan.frames;
  tell((whole ? "wrote " : "stopped early; kept ") + files.summary());
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
