// The rows of the frame store's knobs in the table of an engine that has one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/knob_values.h"

namespace racebeam {

knob_row write_buffer_depth_row();
knob_row write_policy_row();
knob_row when_full_row();

}  // namespace racebeam
