// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/golden_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tb/judge/picture_chain.h"

namespace racebeam {

namespace {

using Tracer = GoldenTracer;

const std::vector<ErrorCause> BeyondTrace4 = {
    {"edge_chatter", "a rounded ray switches more than once at an edge; an interval knows one"},
    {"corner_wrap", "a corner too far for its register counts as behind the camera"},
    {"camera_rounding", "rays are rounded to integers"},
};
// After those of ray_links().
const ErrorCause RayRest = {"ray_rest", "the rest from trace4 to geometry: the camera's products"};
const ErrorCause Unexplained = {
    "unexplained",
    "the chip is not that of the tlm level, or without its limits not trace4: must be 0"};

/// Whether a corner may be too far for its register.
bool has_far_corners(const GoldenWorld& world) {
  const int limit = 1 << (world.corner_bits - 1);
  const auto is_far = [&](const GoldenRoom& room) {
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(room.position[axis]) + room.half_size[axis] + 1 >= limit) return true;
    return false;
  };
  return std::any_of(world.rooms.begin(), world.rooms.end(), is_far);
}

/// trace_2, `picture`, with corners of any size.
GoldenPicture unlimited_corners(GoldenWorld world, const GoldenCamera& camera,
                                const GoldenPicture& picture) {
  if (!has_far_corners(world)) return picture;
  world.corner_bits = 0;
  return golden_picture(Tracer::Trace2, world, camera);
}

constexpr int dimmed(int colour) { return colour >> 1 & 0b010101; }
constexpr int Yellow = 0b111100, Cyan = 0b001111, Magenta = 0b110011;

}  // namespace

const std::vector<ErrorCause>& golden_causes() {
  static const std::vector<ErrorCause> causes = [] {
    std::vector<ErrorCause> all;
    for (const ErrorLink& link : trace_4_links()) all.push_back(link.cause);
    all.insert(all.end(), BeyondTrace4.begin(), BeyondTrace4.end());
    for (const ErrorLink& link : ray_links()) all.push_back(link.cause);
    all.push_back(RayRest);
    all.push_back(Unexplained);
    return all;
  }();
  return causes;
}

int golden_limits() { return static_cast<int>(trace_4_links().size()); }

GoldenCounts::GoldenCounts() : by_cause(golden_causes().size()) {}

PictureErrors& PictureErrors::operator+=(const PictureErrors& more) {
  pixels += more.pixels;
  differing += more.differing;
  by_more += more.by_more;
  wrong_hits += more.wrong_hits;
  squares += more.squares;
  most = std::max(most, more.most);
  return *this;
}

double PictureErrors::rmse() const {
  return pixels ? std::sqrt(static_cast<double>(squares) / (3 * static_cast<double>(pixels))) : 0;
}

double PictureErrors::psnr() const { return 20 * std::log10(most / rmse()); }

GoldenCounts& GoldenCounts::operator+=(const GoldenCounts& more) {
  errors += more.errors;
  for (std::size_t i = 0; i < by_tracer.size(); ++i) by_tracer[i] += more.by_tracer[i];
  for (std::size_t i = 0; i < by_cause.size(); ++i) by_cause[i] += more.by_cause[i];
  return *this;
}

GoldenReport golden_compare(const Show& show, int frame, const knobs& k,
                            const GoldenPicture& chip) {
  const GoldenWorld world = show.golden_world(frame, k);
  const GoldenCamera camera = show.golden_camera(frame, k);
  std::array<GoldenPicture, 3> by_tracer;
  for (const Tracer tracer : {Tracer::Trace2, Tracer::Trace4, Tracer::Geometry})
    by_tracer[static_cast<int>(tracer)] = golden_picture(tracer, world, camera);
  const auto& [trace_2, trace_4, geometry] = by_tracer;

  GoldenReport report;
  for (int i = 0; i < 3; ++i) report.counts.by_tracer[i] = golden_difference(chip, by_tracer[i]);
  std::vector<int>& causes = report.counts.by_cause;
  PictureChain chain(show, frame, k);
  chain.lift(trace_4_links());
  causes = chain.last_changes();
  const std::size_t interval_tracer = chain.size() - 1;
  const int unexplained =
      golden_difference(chip, chain.first()) + golden_difference(chain.last(), trace_4);

  const GoldenPicture far = unlimited_corners(world, camera, trace_2);
  for (const int pixels : {golden_difference(trace_4, trace_2), golden_difference(trace_2, far),
                           golden_difference(far, geometry)})
    causes.push_back(pixels);
  chain.lift(ray_links());
  chain.add(geometry);
  const std::vector<int> of_rays = chain.last_changes(interval_tracer);
  causes.insert(causes.end(), of_rays.begin(), of_rays.end());
  causes.push_back(unexplained);
  report.difference = golden_difference_picture(chip, by_tracer);
  return report;
}

GoldenPicture golden_difference_picture(const GoldenPicture& chip,
                                        const std::array<GoldenPicture, 3>& by_tracer) {
  const auto& [trace_2, trace_4, geometry] = by_tracer;
  GoldenPicture picture(chip.size());
  for (std::size_t i = 0; i < chip.size(); ++i)
    picture[i] = static_cast<std::uint8_t>(chip[i] != trace_4[i]    ? Yellow
                                           : chip[i] != trace_2[i]  ? Cyan
                                           : chip[i] != geometry[i] ? Magenta
                                                                    : dimmed(chip[i]));
  return picture;
}

}  // namespace racebeam
