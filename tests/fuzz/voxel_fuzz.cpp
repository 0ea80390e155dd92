// libFuzzer target: no text makes the reader of voxel worlds crash or hang, and what it finds
// without faults is as the tracer and its host need it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "sc/beam/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "sc/voxel/voxel_world.h"
#include "tb/scene/voxel_scene.h"

// Nobody asks for them.
const racebeam::engine& racebeam::beam_engine() { std::abort(); }
const racebeam::engine& racebeam::sphere_engine() { std::abort(); }
const racebeam::engine& racebeam::voxel_engine() { std::abort(); }

namespace {

using namespace racebeam;

void check(bool good) {
  if (!good) std::abort();
}

void check_views(const VoxelProgram& program) {
  constexpr std::int64_t One = 1 << 24;
  for (const voxel_view& view : program.views) {
    for (std::size_t k = 0; k < 2; ++k)
      check(view.origin[k] >= 0 && view.origin[k] < program.size[k] << 8);
    check(view.origin[2] >= 0 && view.origin[2] < 1 << 23);
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::int64_t y : {0, program.height - 1})
        for (const std::int64_t x : {0, program.width - 1})
          check(std::abs(view.d00[k] + x * view.dx[k] + y * view.dy[k]) <= One);
  }
}

void check_program(const VoxelProgram& program) {
  const voxel_levels levels(program.size, program.voxel);
  check(levels.words() <= 1u << VoxelWordBits);
  const std::size_t columns =
      static_cast<std::size_t>(program.size[0]) * static_cast<std::size_t>(program.size[1]);
  check(program.columns.size() == columns && columns <= std::size_t{1} << VoxelColumnBits);
  check(program.objects.empty() || program.objects.size() == 2 * columns);
  for (const std::uint32_t word : program.columns) {
    const voxel_column c = unpacked_column(word);
    check(c.low <= c.middle && c.middle <= c.high && c.high <= program.size[2]);
  }
  check(program.width >= 8 && program.width <= 640 && program.height >= 1 && program.height <= 480);
  for (const VoxelCrater& crater : program.craters)
    check(crater.radius >= 1 && 2 * crater.radius <= program.size[0] && crater.depth >= 1);
  check_views(program);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Faults faults;
  const std::optional<TomlNode> root = parse_toml(text, faults);
  if (!root) return 0;
  const auto read = read_voxel_scene({*root, text, "fuzz"}, faults);
  (void)faults.text("fuzz");
  (void)faults.warnings("fuzz");
  check(!read == !faults.none());
  if (!read) return 0;
  const auto& scene = static_cast<const VoxelScene&>(*read);
  check(scene.frames() >= 1 && !scene.counts().empty() && !scene.part(0).empty());
  check_program(scene.tables());
  return 0;
}
