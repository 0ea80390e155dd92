// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/frame_renderer.h"

#include <fmt/format.h>

#include "sc/swap/channel_delays.h"
#include "sc/swap/channel_stalls.h"
#include "tb/bench/benches.h"
#include "tb/judge/goldens.h"
#include "tb/judge/hit_maps.h"
#include "tb/monitor/raster.h"
#include "tb/view/map_picture.h"

namespace racebeam {

namespace {

std::unique_ptr<ChipBench> make_bench(const RenderPlan& plan, bool sound) {
  const engine& built = plan.show.engine();
  const planned_stalls stalls(plan.stalls);
  const planned_delays delays(plan.delays);
  return bench_of(built).make(plan.level,
                              {built, plan.k, plan.show.tables(), plan.show.frames(), plan.units},
                              {plan.checksums(), sound, !plan.overlays.empty() || plan.hits});
}

PictureFile overlay_file(const RenderPlan& plan, MapKind kind, const ChipBench::Frame& frame) {
  const Raster raster = plan.raster();
  return picture_file(plan, std::string("overlay_") + map_name(kind), frame.number,
                      map_picture(make_map(kind, frame.intervals, raster),
                                  fmt::format("{} frame {}", plan.show.name(), frame.number)));
}

// With what the colours mean below.
PictureFile difference_file(const RenderPlan& plan, int frame, const GoldenPicture& difference) {
  constexpr int Height = 20, Square = 12, Left = 8, Words = 6, Column = 210;
  constexpr std::pair<int, const char*> meanings[] = {
      {60, "not as trace4"}, {15, "else not as trace2"}, {51, "else not as geometry"}};
  RgbImage picture(difference, VisibleColumns, VisibleRows, VisibleColumns, VisibleRows + Height);
  int left = Left;
  for (const auto& [colour, words] : meanings) {
    picture.fill(left, VisibleRows + 4, Square, Square, rgb_of(colour));
    picture.text(left + Square + Words, VisibleRows + 3, words, {225, 225, 225});
    left += Column;
  }
  return picture_file(plan, "difference", frame, picture);
}

}  // namespace

FrameRenderer::FrameRenderer(const RenderPlan& plan, bool sound)
    : plan_(plan), bench_(make_bench(plan, sound)) {
  if (!plan.vcd.empty())
    wave_ = std::make_unique<FrameWave>(dynamic_cast<WiredBench&>(*bench_), plan.show,
                                        plan.raster(), plan.frames.first(), plan.vcd);
}

void FrameRenderer::finish() {
  if (wave_) wave_->commit();
}

RenderedFrame FrameRenderer::render(int index) {
  bench_->seek(plan_.frames.number(index));
  ChipBench::Frame frame = bench_->render();
  if (plan_.hits)
    show_hits(frame.picture, hits_of(plan_.show.engine()).chip(plan_.show, plan_.k, frame));
  RenderedFrame rendered{frame.number, frame.picture, *frame.stats, {}, {}, frame.time};
  if (plan_.pictures()) rendered.files.push_back(picture_file(plan_, frame.number, frame.picture));
  for (const MapKind kind : plan_.overlays)
    rendered.files.push_back(overlay_file(plan_, kind, frame));
  if (!plan_.compare) return rendered;
  if (const GoldenKind* const golden = golden_of(plan_.show.engine())) {
    rendered.golden.emplace().errors =
        golden->compare(plan_.show.tables(), plan_.k, frame.number, frame.picture, 1);
    return rendered;
  }
  const GoldenReport found =
      golden_compare(plan_.show, frame.number, plan_.k, frame.picture.colours);
  rendered.golden = found.counts;
  if (!plan_.folder.empty())
    rendered.files.push_back(difference_file(plan_, frame.number, found.difference));
  return rendered;
}

}  // namespace racebeam
