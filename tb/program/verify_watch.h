// `racebeam verify --watch`: again whenever a file of the RTL is saved.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command_verify.h"

namespace racebeam {

/// Runs command_verify() in a process of its own, then waits until one of the files of the units'
/// RTL, an include or the scene is saved, until it is interrupted: returns ExitInterrupted.
int verify_watch(const VerifyOptions& options);

}  // namespace racebeam
