// `racebeam doctor`: is everything here that the program needs?
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"

namespace racebeam {

/// Prints versions, the machine, checks that files of each kind can be written, and which optional
/// tools are installed; as JSON if `json`. Returns the exit code; throws MissingTool if a check
/// failed.
struct DoctorOptions {
  bool json = false;
};

int command_doctor(const DoctorOptions& options);

Command doctor_row();

}  // namespace racebeam
