// voxel_golden: the picture that the voxel tracer means, in double precision.
//
// A ray goes through the columns of 1 x 1 that it passes, in their order, and meets the first one's
// solid that its height comes into. There is no octree and no limit; only what the host sends is
// shared with sc/, and the directions are those of voxel_camera, rounded as they are there.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_tables.h"

namespace racebeam {

class VoxelGolden {
 public:
  /// `columns` and `palette` outlive it.
  VoxelGolden(const voxel_knobs& k, const std::vector<std::uint32_t>& columns,
              const voxel_palette& palette, const voxel_view& view)
      : k_(k), columns_(columns), palette_(palette), view_(view) {}

  struct Hit {
    bool sky = true;
    int x = 0, y = 0;    ///< the column, in the world
    bool upper = false;  ///< its solid from middle to high; else that below low
    std::array<double, 3> at{};
  };
  /// Of a pixel's ray.
  Hit hit(int x, int y) const;
  /// Of any ray.
  Hit hit(const std::array<double, 3>& from, const std::array<double, 3>& towards) const;
  /// Red, green and blue of 0..255, cut as voxel_shade does.
  std::array<int, 3> pixel(int x, int y) const;

 private:
  struct Column {
    int low, middle, high, low_material, high_material;
  };
  Column column(int x, int y) const;
  std::array<double, 3> direction(int x, int y) const;
  int slope(const Hit& hit) const;

  const voxel_knobs k_;
  const std::vector<std::uint32_t>& columns_;
  const voxel_palette& palette_;
  const voxel_view view_;
};

}  // namespace racebeam
