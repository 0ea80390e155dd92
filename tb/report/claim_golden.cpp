// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_golden.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tb/golden/geometry.h"
#include "tb/golden/golden_work.h"
#include "tb/golden/tracer_2.h"
#include "tb/judge/tlm_pictures.h"
#include "tb/show/open_show.h"
#include "tb/sweep/fork_server.h"

namespace racebeam {

namespace {

using Json = nlohmann::json;

constexpr const char* Done = "done";
constexpr double Barely = 1e-7;

/// The direction that trace_2 takes a ray for: a negative component of n is one of n + 1 (contract
/// 11.3), and -1 one that is barely negative.
GoldenVector meant(const vec3& dr) {
  GoldenVector ray;
  for (std::size_t a = 0; a < 3; ++a) ray[a] = dr[a] < 0 ? dr[a] + 1 - Barely : dr[a] + Barely;
  return ray;
}

/// Whether geometry sees the same however little the ray is turned: else it passes through an edge.
bool is_tie(const GoldenWorld& world, const GoldenVector& ray, int offset_z, const GoldenHit& hit) {
  constexpr double Turn = 1e-6;
  for (std::size_t a = 0; a < 3; ++a)
    for (const double turn : {-Turn, Turn}) {
      GoldenVector turned = ray;
      turned[a] += turn;
      const GoldenHit other = geometry(world, turned, offset_z);
      if (other.face == hit.face && other.negative == hit.negative) return true;
    }
  return false;
}

/// Rays of every fourth line, each 31st pixel: decided in integers, and by geometry.
std::array<std::int64_t, 2> rays_decided_otherwise(GoldenWorld world, const GoldenCamera& camera) {
  world.corner_bits = 0;  // too far for a register is another matter
  std::array<std::int64_t, 2> counts{};
  for (int row = 0; row < VisibleRows; row += 4) {
    const int y = row - VisibleRows / 2;
    const GoldenRays rays = camera.rays(y);
    for (int pixel = row % 31; pixel < VisibleColumns; pixel += 31) {
      const GoldenVector ray = meant(rays[std::size_t(pixel)]);
      const GoldenHit mine = trace_2(world, rays[std::size_t(pixel)], world.offset_z(y));
      const GoldenHit other = geometry(world, ray, world.offset_z(y));
      ++counts[0];
      if (mine.face == other.face && mine.negative == other.negative) continue;
      counts[1] += !is_tie(world, ray, world.offset_z(y), mine);
    }
  }
  return counts;
}

std::vector<std::int64_t> tracers(const Show& show, int frame, const knobs& k) {
  const GoldenWorld world = show.golden_world(frame, k);
  const GoldenCamera camera = show.golden_camera(frame, k);
  GoldenWork rays, intervals, machine;
  const GoldenPicture by_ray = golden_picture(GoldenTracer::Trace2, world, camera, &rays);
  const GoldenPicture by_interval = golden_picture(GoldenTracer::Trace4, world, camera, &intervals);
  const GoldenPicture by_machine = golden_picture(GoldenTracer::Trace3, world, camera, &machine);
  const auto number = [](std::uint64_t n) { return static_cast<std::int64_t>(n); };
  const std::array<std::int64_t, 2> decided = rays_decided_otherwise(world, camera);
  return {number(rays.decisions),
          number(rays.rooms_entered),
          number(rays.crossing_decisions),
          number(rays.solid_hits),
          number(rays.solid_decisions),
          number(machine.clocks),
          golden_difference(by_ray, by_machine),
          number(intervals.intervals),
          number(intervals.edges),
          number(intervals.chattering_edges),
          golden_difference(by_ray, by_interval),
          decided[0],
          decided[1],
          std::int64_t(VisibleColumns) * VisibleRows};
}

/// Pixels of no colour above or below them, which are alike: the teeth of a ragged edge.
std::int64_t teeth(const GoldenPicture& picture) {
  std::int64_t count = 0;
  for (std::size_t at = VisibleColumns; at + VisibleColumns < picture.size(); ++at)
    count += picture[at - VisibleColumns] == picture[at + VisibleColumns] &&
             picture[at] != picture[at - VisibleColumns];
  return count;
}

std::vector<std::int64_t> motion(const Show& show, int frame, const knobs& k) {
  const GoldenPicture now = TlmPictures(show, frame, k).picture(k);
  const int next = frame + 1 < show.frames() ? frame + 1 : frame - 1;
  const int changed = golden_difference(now, TlmPictures(show, next, k).picture(k));
  return {changed > 0, changed, teeth(now)};
}

}  // namespace

const std::vector<GoldenSet>& golden_sets() {
  static const std::vector<GoldenSet> sets = {
      {"rays",
       {"ray.decisions", "ray.rooms", "ray.crossing_decisions", "ray.solid_hits",
        "ray.solid_decisions", "ray.clocks", "ray.machine_pixels", "interval.intervals",
        "interval.edges", "interval.chattering", "interval.pixels", "exact.rays", "exact.otherwise",
        "pixels"},
       tracers},
      {"motion", {"motion.frames", "motion.pixels", "teeth"}, motion},
  };
  return sets;
}

const GoldenFigure* golden_figure(const std::string& name) {
  static const std::map<std::string, GoldenFigure> figures = [] {
    std::map<std::string, GoldenFigure> all;
    for (const GoldenSet& set : golden_sets())
      for (std::size_t i = 0; i < set.columns.size(); ++i) all[set.columns[i]] = {&set, i};
    return all;
  }();
  const auto at = figures.find(name);
  return at == figures.end() ? nullptr : &at->second;
}

std::string golden_request(const GoldenRequest& request) {
  std::vector<int> values;
  for (std::size_t row = 0; row < request.k.rows().size(); ++row) values.push_back(request.k[row]);
  return Json{
      {"scene", request.scene}, {"set", request.set}, {"knobs", values}, {"frames", request.frames}}
      .dump();
}

void answer_golden(const std::string& request, int file) {
  std::string answer;
  try {
    const Json json = Json::parse(request);
    const Show show = open_show(json.at("scene").get<std::string>());
    const knobs k = knob_values(knob_rows(), json.at("knobs").get<std::vector<int>>());
    for (const GoldenSet& set : golden_sets())
      if (json.at("set") == set.name)
        for (const int frame : json.at("frames")) {
          answer = std::to_string(frame);
          for (const std::int64_t value : set.find(show, frame, k))
            answer += " " + std::to_string(value);
          if (!send_all(file, answer + "\n")) return;
        }
    answer = Done;
  } catch (const std::exception& error) {
    answer = error.what();
  }
  send_all(file, answer + "\n");
}

std::map<int, std::vector<std::int64_t>> golden_answer(const std::string& lines) {
  std::map<int, std::vector<std::int64_t>> frames;
  std::istringstream in(lines);
  std::string last;
  for (std::string line; std::getline(in, line); last = line) {
    std::istringstream words(line);
    int frame = 0;
    if (!(words >> frame)) continue;
    std::vector<std::int64_t>& values = frames[frame];
    for (std::int64_t value = 0; words >> value;) values.push_back(value);
  }
  if (last != Done)
    throw std::runtime_error("a worker with golden tracers ended early" +
                             (last.empty() ? "" : ": " + last));
  return frames;
}

}  // namespace racebeam
