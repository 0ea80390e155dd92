// The scene that `racebeam scene new` writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// A scene file without faults, to start from.
const char* starter_scene();

}  // namespace racebeam
