// What can be said of a scene as a whole: overlaps, portals that do not fit a face, the camera's
// way, and the widths that its chip needs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/scene/faults.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

/// What a chip needs to show a scene.
struct SceneWidths {
  int room_bits = 0;         ///< room number; all bits set means solid
  int corner_bits = 0;       ///< signed: from the camera to a far corner in sight
  int camera_bits = 0;       ///< signed: from the centre of a room to the camera
  int portals_per_face = 0;  ///< 1 on the chip
};

/// Widths of a scene without faults. corner_bits is what no corner exceeds, whatever the file says.
SceneWidths scene_widths(const SceneFile& scene);
/// The corner bits to build: what the file asks for, or what is needed.
int built_corner_bits(const SceneFile& scene, const SceneWidths& widths);

/// Adds all faults of a scene whose rooms are read and connected.
void check_rooms(const SceneFile& scene, Faults& faults);
/// Adds the faults of the camera's way and of the corner bits; rooms and shots are good.
void check_views(const SceneFile& scene, Faults& faults);

/// Warns of rooms that no portals lead to from where the camera is set down.
void warn_of_lost_rooms(const SceneFile& scene, Faults& faults);

}  // namespace racebeam
