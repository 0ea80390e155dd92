// libFuzzer target: no text makes a reader of scenes of spheres crash or hang, and what it finds
// without faults is as the tracer, or renderer, and its host need it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "sc/block/codes.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "tb/scene/block_scene.h"
#include "tb/scene/sphere_scene.h"

// Nobody asks for them.
const racebeam::engine& racebeam::sphere_engine() { std::abort(); }
const racebeam::engine& racebeam::block_engine() { std::abort(); }

namespace {

void check(bool good) {
  if (!good) std::abort();
}

using namespace racebeam;

void expect_faults_or(const AnyScene* read, const Faults& faults) {
  (void)faults.text("fuzz");
  (void)faults.warnings("fuzz");
  check(!read == !faults.none());
  check(!read || (read->frames() >= 1 && !read->counts().empty() && !read->part(0).empty()));
}

void check_spheres(const SphereProgram& program) {
  check(program.spheres >= 1 && program.spheres < SphereEntries);
  check(program.planes.size() <= PlaneEntries);
  for (const SphereInput& input : program.inputs)
    check(input.sw >> 18 == 0 && input.keys >> 4 == 0 && input.pictures >= 1);
  SphereMotion motion(program.moving, program.box);
  for (int picture = 0; picture < 8; ++picture) {
    motion.picture(program.inputs_before(picture).rotz_q);
    for (const sphere_row& row : motion.table()) check(row.radius >= 1 && row.radius <= 63);
  }
}

/// Squares of ways from a to b, which are 12.20, stay below `limit`.
void check_way(const vec3& a, const vec3& b, int limit) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) square += (double(a[k]) - b[k]) * (double(a[k]) - b[k]);
  check(square < std::ldexp(limit + 0.5, 2 * BlockFraction));  // they were rounded
}

void check_blocks(const BlockProgram& program) {
  check(!program.balls.empty() && program.balls.size() <= BlockEntries);
  BlockMotion motion(program, {});
  for (int picture = 0; picture < 8; ++picture, motion.picture()) {
    const block_world world = converted(motion.tables(), {});
    check(world.start[2] != 0);
    check_way(world.start, {}, 1024);
    for (const block_row& row : world.rows) {
      check(row.radius2 > 0 && row.radius2 >> BlockRootBits == 0);
      check_way(world.light, row.centre, 1024);
      for (const block_row& other : world.rows) check_way(row.centre, other.centre, 2048);
      check_way(row.pose, {}, 2048);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Faults faults;
  const std::optional<TomlNode> root = parse_toml(text, faults);
  if (!root) return 0;
  Faults of_spheres = faults, of_blocks = faults;
  const auto spheres = read_sphere_scene({*root, text, "fuzz"}, of_spheres);
  expect_faults_or(spheres.get(), of_spheres);
  if (spheres) check_spheres(static_cast<const SphereScene&>(*spheres).tables());
  const auto blocks = read_block_scene({*root, text, "fuzz"}, of_blocks);
  expect_faults_or(blocks.get(), of_blocks);
  if (blocks) check_blocks(static_cast<const BlockScene&>(*blocks).tables());
  return 0;
}
