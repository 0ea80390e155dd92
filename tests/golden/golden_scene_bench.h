// A scene as the golden tracers show it: text or file in, pictures and hits out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/geometry.h"
#include "tb/golden/tracer_2.h"
#include "tb/golden/tracer_4.h"
#include "tb/scene/scene_check.h"
#include "tests/support/scene_text.h"

namespace racebeam {

constexpr GoldenTracer GoldenTracers[] = {GoldenTracer::Trace2, GoldenTracer::Trace4,
                                          GoldenTracer::Geometry};

/// A [[room]] of a scene file.
inline std::string room(const std::string& id, const std::string& centre,
                        const std::string& half_size, const std::string& portals = "") {
  return "[[room]]\nid = \"" + id + "\"\ncentre = [" + centre + "]\nhalf_size = [" + half_size +
         "]\n" + (portals.empty() ? "" : "portals = { " + portals + " }\n");
}

class GoldenScene {
 public:
  explicit GoldenScene(SceneFile of_file) : scene(std::move(of_file)), path(fly(scene)) {
    k.corner_bits = built_corner_bits(scene, scene_widths(scene));
  }
  explicit GoldenScene(const std::string& text) : GoldenScene(good_scene(text)) {}

  GoldenWorld world(int frame) const { return {scene, path, frame, k}; }
  GoldenCamera camera(int frame) const { return {scene, frame}; }
  GoldenPicture picture(GoldenTracer tracer, int frame) const {
    return golden_picture(tracer, world(frame), camera(frame));
  }

  /// What a tracer says of one pixel of frame 0.
  GoldenHit hit(GoldenTracer tracer, int pixel, int y) const {
    const GoldenWorld seen = world(0);
    if (tracer == GoldenTracer::Geometry) return geometry_line(seen, camera(0).ideal(y), y)[pixel];
    const GoldenRays rays = camera(0).rays(y);
    const GoldenHits hits =
        tracer == GoldenTracer::Trace2 ? trace_2_line(seen, rays, y) : trace_4_line(seen, rays, y);
    return hits[pixel];
  }

  SceneFile scene;
  CameraPath path;
  knobs k;
};

}  // namespace racebeam
