// Where the traffic of a replay of all frames comes from, and what tells one such replay from
// others.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "tb/program/replay_part.h"
#include "tb/program/verify_replay.h"
#include "tb/twin/traffic_file.h"

namespace racebeam {

/// The ports of the unit, and what traffic of it is of.
TrafficHead replay_head(const Replay& what);

/// Lines of "word text": unit, scene, knobs, model, RTL.
std::string replay_key(const Replay& what, const TrafficHead& head);

/// The traffic of consecutive frames; of a chip without cores it is captured to a file in `folder`,
/// whose path `file` then has.
std::unique_ptr<TrafficSource> part_source(const Replay& what, const TrafficHead& head,
                                           const ReplayPart& part, const std::string& folder,
                                           std::string& file);

}  // namespace racebeam
