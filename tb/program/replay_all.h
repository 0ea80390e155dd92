// `racebeam verify --replay all`: every frame of a show into RTL without SystemC, in parts that
// survive a kill.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/verify_replay.h"

namespace racebeam {

/// In the place of a file.
constexpr const char* AllFrames = "all";

/// The traffic is made on the way: of the beam's chip by its cores, of another one by the wired
/// chip. FOLDER/UNIT holds a file for each part that is done; the same command goes on where it
/// ended. Throws UsageError: the parts there are of something else, or another process is at work.
int verify_all_frames(const VerifyOptions& options);

}  // namespace racebeam
