// Who waits for whom in the chips that draw into a frame store.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/bench/waits.h"

namespace racebeam {

std::unique_ptr<WaitWatch> make_sphere_waits(const wired_chip& chip, const knob_values& k);
std::unique_ptr<WaitWatch> make_block_waits(const wired_chip& chip, const knob_values& k);
std::unique_ptr<WaitWatch> make_voxel_waits(const wired_chip& chip, const knob_values& k);

}  // namespace racebeam
