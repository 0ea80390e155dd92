// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/counters.h"

#include <iterator>

namespace racebeam {

namespace {

struct counter_row {
  counter_info info;
  std::uint64_t sphere_counters::*member;
};

const counter_row counters[] = {
    {{"clocks", "clocks", 12}, &sphere_counters::clocks},
    {{"host_clocks", "host clocks", 12}, &sphere_counters::host_clocks},
    {{"frames", "frames", 7}, &sphere_counters::frames},
    {{"primary_rays", "primary rays", 0}, &sphere_counters::primary_rays},
    {{"reflected_rays", "reflected rays", 15}, &sphere_counters::reflected_rays},
    {{"shadow_rays", "shadow rays", 12}, &sphere_counters::shadow_rays},
    {{"sphere_tests", "sphere tests", 13}, &sphere_counters::sphere_tests},
    {{"plane_tests", "plane tests", 12}, &sphere_counters::plane_tests},
    {{"roots", "", 0}, &sphere_counters::roots},
    {{"divisions", "", 0}, &sphere_counters::divisions},
    {{"hits", "", 0}, &sphere_counters::hits},
    {{"passes", "", 0}, &sphere_counters::passes},
    {{"shadowed", "", 0}, &sphere_counters::shadowed},
    {{"black_inside", "", 0}, &sphere_counters::black_inside},
    {{"overflows", "", 0}, &sphere_counters::overflows},
    {{"words", "", 0}, &sphere_counters::words},
    {{"buffer_stalls", "buffer stalls", 14}, &sphere_counters::buffer_stalls},
    {{"buffer_lost", "words lost", 0}, &sphere_counters::buffer_lost},
    {{"store_reads", "", 0}, &sphere_counters::store_reads},
    {{"store_writes", "", 0}, &sphere_counters::store_writes},
    {{"host_faults", "", 0}, &sphere_counters::host_faults},
};

struct state_name {
  int code;
  const char* word;
  const char* counter;
};

// In the order in which a ray goes through them.
const state_name states[] = {
    {SphereHost, "HOST", "state_host"},
    {SphereRay, "RAY", "state_ray"},
    {SphereRoot, "ROOT", "state_root"},
    {SphereDivide, "DIVIDE", "state_divide"},
    {SphereCentre, "CENTRE", "state_centre"},
    {SphereAlong, "ALONG", "state_along"},
    {SphereFront, "FRONT", "state_front"},
    {SphereChord, "CHORD", "state_chord"},
    {SphereWait, "WAIT", "state_wait"},
    {SphereHit, "HIT", "state_hit"},
    {SpherePlane, "PLANE", "state_plane"},
    {SpherePlaneD, "PLANE_D", "state_plane_d"},
    {SpherePlaneT, "PLANE_T", "state_plane_t"},
    {SphereLight, "LIGHT", "state_light"},
    {SphereLray, "LRAY", "state_lray"},
    {SphereLroot, "LROOT", "state_lroot"},
    {SphereLdivide, "LDIVIDE", "state_ldivide"},
    {SphereNormal, "NORMAL", "state_normal"},
    {SphereLambert, "LAMBERT", "state_lambert"},
    {SphereShade, "SHADE", "state_shade"},
    {SphereShadowCentre, "S_CENTRE", "state_s_centre"},
    {SphereShadowAlong, "S_ALONG", "state_s_along"},
    {SphereShadowFront, "S_FRONT", "state_s_front"},
    {SphereShadowChord, "S_CHORD", "state_s_chord"},
    {SphereAdd, "ADD", "state_add"},
    {SphereReflect, "REFLECT", "state_reflect"},
    {SphereNext, "NEXT", "state_next"},
};

}  // namespace

std::vector<std::string> sphere_state_words() {
  std::vector<std::string> words;
  for (int code = 0; code < SphereStates; ++code) words.push_back(std::to_string(code));
  for (const state_name& state : states) words[state.code] = state.word;
  words[SphereReflectTwo] = words[SphereReflect];
  return words;
}

std::vector<counter_info> sphere_counter_infos() {
  std::vector<counter_info> infos;
  for (const counter_row& row : counters) infos.push_back(row.info);
  for (const state_name& state : states) infos.push_back({state.counter, "", 0});
  return infos;
}

std::vector<histogram_info> sphere_histogram_infos() {
  return {{"buffer_fill", "write_buffer_depth"}};
}

frame_counts counted(const sphere_counters& from) {
  frame_counts counts;
  for (const counter_row& row : counters) counts.counters.push_back(from.*row.member);
  for (const state_name& state : states)
    counts.counters.push_back(from.state_clocks[static_cast<std::size_t>(state.code)]);
  counts.histograms.emplace_back(from.buffer_fill.begin(), from.buffer_fill.end());
  return counts;
}

}  // namespace racebeam
