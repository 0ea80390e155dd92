// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/columns.h"

#include <string_view>

#include "tb/base/spread.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

std::vector<std::string> sweep_columns(const engine& built) {
  std::vector<std::string> columns;
  for (const counter_info& counter : built.counters) columns.emplace_back(counter.name);
  for (const line_info& line : built.lines)
    for (const char* part : {".sum", ".p99", ".max", ".never"})
      columns.push_back(std::string(line.name) + part);
  for (const char* name : {"error_pixels", "visible_error_pixels", PictureColumn})
    columns.emplace_back(name);
  return columns;
}

std::vector<std::int64_t> column_values(const frame_counts& counts, const FrameErrors& errors,
                                        const std::vector<std::uint8_t>& colours) {
  std::vector<std::int64_t> values;
  for (const std::uint64_t counter : counts.counters)
    values.push_back(static_cast<std::int64_t>(counter));
  for (const std::vector<int>& line : counts.lines) {
    Spread spread;
    std::int64_t never = 0;
    for (const int value : line)
      if (value < 0) ++never;
      else spread.add(value);
    const bool any = spread.count() > 0;
    values.push_back(static_cast<std::int64_t>(spread.sum()));
    values.push_back(any ? spread.percentile(99) : 0);
    values.push_back(any ? spread.max() : 0);
    values.push_back(never);
  }
  values.push_back(errors.error_pixels);
  values.push_back(errors.visible_error_pixels);
  values.push_back(picture_digest({reinterpret_cast<const char*>(colours.data()), colours.size()}));
  return values;
}

}  // namespace racebeam
