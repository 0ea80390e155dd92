// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/counters.h"

#include <utility>

namespace racebeam {

namespace {

struct counter_row {
  counter_info info;
  std::uint64_t (*value)(const voxel_counters&);
};

using n = const voxel_counters&;

const counter_row counters[] = {
    {{"clocks", "clocks", 12}, [](n c) { return c.clocks; }},
    {{"host_clocks", "host clocks", 12}, [](n c) { return c.host_clocks; }},
    {{"build_clocks", "build clocks", 13}, [](n c) { return c.build_clocks; }},
    {{"build_columns", "columns built", 0}, [](n c) { return c.build_columns; }},
    {{"rectangles", "", 0}, [](n c) { return c.rectangles; }},
    {{"frames", "frames", 7}, [](n c) { return c.frames; }},
    {{"walk_clocks", "walk clocks", 12}, [](n c) { return c.walk_clocks; }},
    {{"shadow_clocks", "", 0}, [](n c) { return c.shadow_clocks; }},
    {{"shade_clocks", "", 0}, [](n c) { return c.shade_clocks; }},
    {{"fetches", "fetches", 11}, [](n c) { return c.walked.fetches(); }},
    {{"fetched_words", "", 0}, [](n c) { return c.walked.words(); }},
    {{"moves", "moves", 10}, [](n c) { return c.walked.moves; }},
    {{"descents", "descents", 10}, [](n c) { return c.walked.descents; }},
    {{"raises", "", 0}, [](n c) { return c.walked.raises; }},
    {{"samples", "samples", 9}, [](n c) { return c.walked.samples; }},
    {{"column_reads", "", 0}, [](n c) { return c.walked.column_reads + c.shade_reads; }},
    {{"sky", "sky", 8}, [](n c) { return c.ends[VoxelSky]; }},
    {{"hits", "hits", 8}, [](n c) { return c.ends[VoxelHit]; }},
    {{"outer_limited", "outer limit", 0}, [](n c) { return c.ends[VoxelOuterLimit]; }},
    {{"inner_limited", "inner limit", 0}, [](n c) { return c.ends[VoxelInnerLimit]; }},
    {{"shadow_rays", "", 0}, [](n c) { return c.shadow_rays; }},
    {{"shadowed", "in shadow", 0}, [](n c) { return c.shadowed; }},
    {{"words", "", 0}, [](n c) { return c.words; }},
    {{"buffer_stalls", "buffer stalls", 14}, [](n c) { return c.buffer_stalls; }},
    {{"buffer_lost", "words lost", 0}, [](n c) { return c.buffer_lost; }},
    {{"store_reads", "", 0}, [](n c) { return c.store_reads; }},
    {{"store_writes", "", 0}, [](n c) { return c.store_writes; }},
};

/// With the codes that have no word.
std::vector<std::string> all_words(std::vector<std::string> words, int bits) {
  for (int code = static_cast<int>(words.size()); code < 1 << bits; ++code)
    words.push_back(std::to_string(code));
  return words;
}

template <class Values>
std::vector<std::uint64_t> all(const Values& values) {
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<std::string> voxel_state_words() {
  return all_words({"IDLE", "SETUP", "FETCH", "DOWN", "EXIT", "LEAF", "MOVE", "LIMIT"},
                   VoxelStateBits);
}
std::vector<std::string> voxel_scan_words() {
  return all_words({"IDLE", "RAY", "SHADOW", "SHADE"}, VoxelScanStateBits);
}
std::vector<std::string> voxel_builder_words() {
  return all_words({"IDLE", "CLEAR", "FILL", "UP"}, VoxelBuilderStateBits);
}

std::vector<counter_info> voxel_counter_infos() {
  std::vector<counter_info> infos;
  for (const counter_row& row : counters) infos.push_back(row.info);
  return infos;
}

std::vector<histogram_info> voxel_histogram_infos() {
  return {{"fetches_by_level", "levels", 0, 1},
          {"words_by_level", "levels", 0, 1},
          {"buffer_fill", "write_buffer_depth"}};
}

frame_counts counted(const voxel_counters& from) {
  frame_counts counts;
  for (const counter_row& row : counters) counts.counters.push_back(row.value(from));
  counts.histograms = {all(from.walked.fetches_by_level), all(from.walked.words_by_level),
                       all(from.buffer_fill)};
  return counts;
}

}  // namespace racebeam
