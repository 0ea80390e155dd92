// `racebeam doctor`: is everything here that the program needs?
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Prints versions, the machine, checks that files of each kind can be written, and which optional
/// tools are installed; as JSON if `json`. Returns the exit code; throws MissingTool if a check
/// failed.
int command_doctor(bool json);

}  // namespace racebeam
