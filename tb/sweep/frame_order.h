// The order in which a sweep takes the frames of a scene: any first part of it lies evenly over the
// scene, so that more frames only add to those that are there.
//
// Number i is floor(N * frac(vdc(i) + u)), vdc the van der Corput sequence in base 2, u from the
// seed; frames met before are skipped. Exact in integers: the same on any machine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace racebeam {

/// All frames of `allowed` (those of a show, less the ones left out), once each, in the order in
/// which they are taken. Over all seeds each frame is as likely as any other at every place.
std::vector<int> frame_order(const std::vector<int>& allowed, std::uint64_t seed);

}  // namespace racebeam
