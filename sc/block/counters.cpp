// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/counters.h"

#include <iterator>
#include <numeric>

namespace racebeam {

namespace {

struct counter_row {
  counter_info info;
  std::uint64_t block_counters::*member;
};

const counter_row counters[] = {
    {{"clocks", "clocks", 12}, &block_counters::clocks},
    {{"host_clocks", "host clocks", 12}, &block_counters::host_clocks},
    {{"frames", "frames", 7}, &block_counters::frames},
    {{"busy_clocks", "busy clocks", 13}, &block_counters::busy_clocks},
    {{"blocks", "", 0}, &block_counters::blocks},
    {{"cleared", "blocks cleared", 15}, &block_counters::cleared},
    {{"groups", "groups", 10}, &block_counters::groups},
    {{"groups_skipped", "", 0}, &block_counters::groups_skipped},
    {{"roots", "roots", 10}, &block_counters::roots},
    {{"small_vectors", "", 0}, &block_counters::small_vectors},
    {{"root_out_of_range", "", 0}, &block_counters::root_out_of_range},
    {{"words", "", 0}, &block_counters::words},
    {{"bus_stalls", "bus stalls", 12}, &block_counters::bus_stalls},
    {{"buffer_stalls", "buffer stalls", 14}, &block_counters::buffer_stalls},
    {{"buffer_lost", "words lost", 0}, &block_counters::buffer_lost},
    {{"store_reads", "", 0}, &block_counters::store_reads},
    {{"store_writes", "", 0}, &block_counters::store_writes},
};

template <class Values>
std::vector<std::uint64_t> all(const Values& values) {
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<std::string> block_state_words() {
  std::vector<std::string> words = {"IDLE",  "JOB",   "CORNER", "CULL",         "CLEAR",
                                    "PIXEL", "GROUP", "NEAR",   "DECIDE",       "SHADE",
                                    "STORE", "WORDS", "SHADOW", "SHADOW_GROUP", "SHADOW_NEAR"};
  for (int code = static_cast<int>(words.size()); code < 1 << BlockStateBits; ++code)
    words.push_back(std::to_string(code));
  return words;
}

std::vector<counter_info> block_counter_infos() {
  std::vector<counter_info> infos;
  for (const counter_row& row : counters) infos.push_back(row.info);
  infos.push_back({"shades", "shades", 10});
  return infos;
}

std::vector<histogram_info> block_histogram_infos() {
  return {{"kept_by_corner", nullptr, BlockCorners - 1},
          {"shades_by_pass", "max_passes", 0, 1},
          {"busy_by_core", "cores", 0, 1},
          {"buffer_fill", "write_buffer_depth"}};
}

frame_counts counted(const block_counters& from) {
  frame_counts counts;
  for (const counter_row& row : counters) counts.counters.push_back(from.*row.member);
  counts.counters.push_back(
      std::accumulate(from.shades.begin(), from.shades.end(), std::uint64_t{0}));
  counts.histograms = {all(from.kept_by_corner), all(from.shades), all(from.busy_by_core),
                       all(from.buffer_fill)};
  return counts;
}

}  // namespace racebeam
