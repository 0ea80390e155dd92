// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/golden_compare.h"

#include "tb/judge/core_renderer.h"

namespace racebeam {

namespace {

using Tracer = GoldenTracer;

/// A limit of the chip that knobs switch off.
struct Limit {
  GoldenCause cause;
  void (*lift)(knobs&);
};

constexpr int MaxStack = 64, MaxFifo = 64, MaxClocks = 8, WholeFactor = 16;

const std::vector<Limit> Limits = {
    {{"give_up", "a starved beam takes short intervals as they are"},
     [](knobs& k) { k.hurry_threshold = -1; }},
    {{"starved", "the beam overtakes the tracer; a late interval is dark from end to end"},
     [](knobs& k) { k.clocks_per_pixel = MaxClocks, k.fifo_entries = MaxFifo, k.speed = 0; }},
    {{"stack", "the interval stack overflows"},
     [](knobs& k) { k.interval_stack_depth = MaxStack; }},
    {{"multiplier_cut", "the small partial products are dropped"},
     [](knobs& k) { k.partial_products_cut = 0; }},
    {{"corner_shift", "large corners lose low bits"},
     [](knobs& k) { k.corner_factor_bits = WholeFactor; }},
    {{"other_knobs", "knobs that the tracers do not follow: dr_bits, stepping, skip_shared_edges"},
     [](knobs& k) {
       const knobs defaults;
       k.dr_bits = defaults.dr_bits;
       k.stepping = defaults.stepping;
       k.skip_shared_edges = defaults.skip_shared_edges;
     }},
};

const std::vector<GoldenCause> AfterLimits = {
    {"interlace_residue", "odd lines: what a way back to the root leaves in the corner"},
    {"edge_chatter", "a rounded ray switches more than once at an edge; an interval knows one"},
    {"corner_wrap", "a corner too far for its register counts as behind the camera"},
    {"camera_rounding", "rays are rounded to integers"},
    {"unexplained",
     "the chip is not its cores in a loop, or without its limits not trace_4: must be 0"},
};

GoldenPicture unlimited_corners(GoldenWorld world, const GoldenCamera& camera) {
  world.corner_bits = 0;
  return golden_picture(Tracer::Trace2, world, camera);
}

/// Pixels by which the chip is not trace_4 once limits and interlace are off.
int unlimited_difference(const Show& show, int frame, knobs k, const GoldenCamera& camera) {
  k.interlace = 0;
  return golden_difference(core_picture(frame, k, show.program()),
                           golden_picture(Tracer::Trace4, show.golden_world(frame, k), camera));
}

/// For each link of a chain of pictures: the pixels that differ between its ends and change in this
/// link for the last time.
std::vector<int> last_changes(const std::vector<GoldenPicture>& chain) {
  std::vector<int> counts(chain.size() - 1);
  for (std::size_t pixel = 0; pixel < chain[0].size(); ++pixel) {
    if (chain.front()[pixel] == chain.back()[pixel]) continue;
    std::size_t link = chain.size() - 1;
    while (chain[link - 1][pixel] == chain[link][pixel]) --link;
    ++counts[link - 1];
  }
  return counts;
}

constexpr int dimmed(int colour) { return colour >> 1 & 0b010101; }
constexpr int Yellow = 0b111100, Cyan = 0b001111, Magenta = 0b110011;

}  // namespace

const std::vector<GoldenCause>& golden_causes() {
  static const std::vector<GoldenCause> causes = [] {
    std::vector<GoldenCause> all;
    for (const Limit& limit : Limits) all.push_back(limit.cause);
    all.insert(all.end(), AfterLimits.begin(), AfterLimits.end());
    return all;
  }();
  return causes;
}

int golden_limits() { return static_cast<int>(Limits.size()) + 1; }

GoldenCounts::GoldenCounts() : by_cause(golden_causes().size()) {}

GoldenCounts& GoldenCounts::operator+=(const GoldenCounts& more) {
  for (std::size_t i = 0; i < by_tracer.size(); ++i) by_tracer[i] += more.by_tracer[i];
  for (std::size_t i = 0; i < by_cause.size(); ++i) by_cause[i] += more.by_cause[i];
  return *this;
}

GoldenReport golden_compare(const Show& show, int frame, const knobs& k,
                            const GoldenPicture& chip) {
  const GoldenWorld world = show.golden_world(frame, k);
  const GoldenCamera camera = show.golden_camera(frame);
  std::array<GoldenPicture, 3> by_tracer;
  for (const Tracer tracer : {Tracer::Trace2, Tracer::Trace4, Tracer::Geometry})
    by_tracer[static_cast<int>(tracer)] = golden_picture(tracer, world, camera);
  const auto& [trace_2, trace_4, geometry] = by_tracer;

  GoldenReport report;
  for (int i = 0; i < 3; ++i) report.counts.by_tracer[i] = golden_difference(chip, by_tracer[i]);
  std::vector<GoldenPicture> chain = {core_picture(frame, k, show.program())};
  const int foreign = golden_difference(chip, chain.back());
  knobs lifted = k;
  for (const Limit& limit : Limits) {
    const knobs limited = lifted;
    limit.lift(lifted);
    chain.push_back(limited == lifted ? chain.back() : core_picture(frame, lifted, show.program()));
  }
  const int left = golden_difference(chain.back(), trace_4);
  chain.push_back(world.interlace ? trace_4 : chain.back());

  const GoldenPicture far = unlimited_corners(world, camera);
  report.counts.by_cause = last_changes(chain);
  for (const int pixels :
       {golden_difference(trace_4, trace_2), golden_difference(trace_2, far),
        golden_difference(far, geometry),
        foreign + (world.interlace ? unlimited_difference(show, frame, lifted, camera) : left)})
    report.counts.by_cause.push_back(pixels);
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
