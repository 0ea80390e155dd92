// The words for faces, ends of intervals, and what happens in a clock of the tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/explain/line_story.h"

namespace racebeam {

/// "south -z": the face of a room by which a ray leaves it.
std::string face_text(int axis, bool negative);
/// "LEFT", "RIGHT", "BISECT", "RETURN".
const char* state_name(int state);
/// "solid", "missed", "too_deep", "given_up", "never".
const char* end_name(IntervalEnd end);
/// What is asked at a place in the tree: "far edge in x"; and what was answered: "inside".
std::string question_text(const TracerStep& step);
std::string answer_text(const TracerStep& step);
/// What came of a step: "descend", "push", "emit", "wait", "climb", "pop", "restart" ...
std::vector<std::string> outcomes(const TracerStep& step);

}  // namespace racebeam
