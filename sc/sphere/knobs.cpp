// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/knobs.h"

#include <algorithm>
#include <iterator>

#include "sc/store/store_knob_rows.h"

namespace racebeam {

const std::vector<sphere_knob_info>& sphere_knob_table() {
  using k = sphere_knobs;
  static const std::vector<std::string> switched = {"off", "on"};
  static const sphere_knob_info rows[] = {
      {{"fraction_bits",
        6,
        12,
        {},
        "bits",
        "fraction bits of positions and directions; those below are 0",
        "report \"Square Root\""},
       &k::fraction_bits},
      {{"colour_bits", 4, 8, {}, "bits", "a channel in the frame store", "report \"VGA/SRAM\""},
       &k::colour_bits},
      {{"root_bits_per_clock",
        1,
        22,
        {},
        "bits",
        "digits of the root in a clock; it has 22, and takes 2 clocks besides",
        "report \"Square Root\""},
       &k::root_bits_per_clock},
      {{"divide_clocks",
        1,
        36,
        {},
        "clocks",
        "a division of 36 by 24 bits",
        "report \"State Machine\""},
       &k::divide_clocks},
      {{"table_entries",
        2,
        16,
        {},
        "entries",
        "sphere table; the light has one of them",
        "report \"Communication\""},
       &k::table_entries},
      {write_buffer_depth_row(), &k::write_buffer_depth},
      {write_policy_row(), &k::write_policy},
      {when_full_row(), &k::when_full},
      {{"write_each_pass", 0, 1, switched, "",
        "a word is written after every ray that met something and every sub-ray, not once a pixel",
        "report \"State Machine\""},
       &k::write_each_pass},
      {{"shadow_rays", 0, 1, switched, "", "spheres cast shadows", "report \"State Machine\""},
       &k::shadow_rays},
      {{"plane_shadows", 0, 1, switched, "", "planes cast shadows, too; the source has none",
        "report \"State Machine\""},
       &k::plane_shadows},
      {{"min_weight",
        0,
        4095,
        {},
        "of 4096",
        "a reflection of less weight is not followed",
        "report \"State Machine\""},
       &k::min_weight},
      {{"wrap_right", 0, 1, switched, "", "columns above 511 show the left part again",
        "report \"VGA/SRAM\""},
       &k::wrap_right},
      {{"wide", 0, 1, switched, "", "the large picture has 640 columns, not 512",
        "beyond the source"},
       &k::wide},
      {{"clocks_per_pixel", 1, 8, {}, "clocks", "of the raster", "report \"VGA/SRAM\""},
       &k::clocks_per_pixel},
      {{"host_clocks_per_word",
        1,
        64,
        {},
        "clocks",
        "a word from or to the CPU",
        "report \"Communication\""},
       &k::host_clocks_per_word},
      {{"capture_guard",
        0,
        2,
        {"counter", "approach", "off"},
        "",
        "what keeps two spheres that met from meeting again at once",
        "report \"Software Overview\""},
       &k::capture_guard},
      {{"as_built", 0, 1, switched, "",
        "write_each_pass, when_full = drop and table_entries = 5 at once",
        "the source's last build"},
       &k::as_built},
  };
  static_assert(std::size(rows) * sizeof(int) == sizeof(sphere_knobs), "a knob has no row");
  static const std::vector<sphere_knob_info> table(std::begin(rows), std::end(rows));
  return table;
}

const std::vector<knob_row>& sphere_knob_rows() {
  static const std::vector<knob_row> rows = rows_of(sphere_knob_table());
  return rows;
}

sphere_knobs::sphere_knobs(const knob_values& values) {
  put_values(sphere_knob_table(), sphere_knob_rows(), values, *this);
}
sphere_knobs::operator knob_values() const {
  return values_of(sphere_knob_table(), sphere_knob_rows(), *this);
}

bool operator==(const sphere_knobs& a, const sphere_knobs& b) {
  const auto& rows = sphere_knob_table();
  return std::all_of(rows.begin(), rows.end(),
                     [&](const sphere_knob_info& row) { return a.*row.member == b.*row.member; });
}

}  // namespace racebeam
