// libFuzzer target: no text makes the reader of scenes of spheres crash or hang, and what it finds
// without faults is as the sphere tracer and its CPU need it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "sc/sphere/engine.h"
#include "tb/scene/sphere_scene.h"

// Nobody asks for it.
const racebeam::engine& racebeam::sphere_engine() { std::abort(); }

namespace {

void check(bool good) {
  if (!good) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  Faults faults;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::optional<TomlNode> root = parse_toml(text, faults);
  const auto read = root ? read_sphere_scene({*root, text, "fuzz"}, faults) : nullptr;
  (void)faults.text("fuzz");
  (void)faults.warnings("fuzz");
  check(!read == !faults.none());
  if (!read) return 0;
  const auto& program = static_cast<const SphereScene&>(*read).tables();
  check(program.spheres >= 1 && program.spheres < SphereEntries);
  check(program.planes.size() <= PlaneEntries);
  check(read->frames() >= 1 && !read->counts().empty() && !read->part(0).empty());
  for (const SphereInput& input : program.inputs)
    check(input.sw >> 18 == 0 && input.keys >> 4 == 0 && input.pictures >= 1);
  SphereMotion motion(program.moving, program.box);
  for (int picture = 0; picture < 8; ++picture) {
    motion.picture(program.inputs_before(picture).rotz_q);
    for (const sphere_row& row : motion.table()) check(row.radius >= 1 && row.radius <= 63);
  }
  return 0;
}
