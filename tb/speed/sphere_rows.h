// What `racebeam bench spheres` counts: clocks that the sphere tracer takes for a pixel, by the
// number of spheres.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace racebeam {

/// A row for each number of spheres, which stand in a ring before the eye: "spheres", "clocks" of
/// the picture, "clocks_per_pixel", "pictures_per_second" at 25.2 MHz.
nlohmann::json sphere_rows();

/// Those as a table, as docs/sphere.md has it.
std::string sphere_text(const nlohmann::json& rows);

}  // namespace racebeam
