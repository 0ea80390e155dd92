// Work that several processes share, each line of whose answers arrives as it is written.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace racebeam {

/// Says a line, without its end.
using SayLine = std::function<void(const std::string& line)>;

/// Forks `processes`; each runs `work` with its number, 0 and up, and what it says is given to
/// `take`, in any order. Throws what `take` throws, RtlError with the text of what a process has
/// thrown, ChildDied, Interrupted; none is left then.
void share_work(int processes, const std::function<void(int number, const SayLine& say)>& work,
                const std::function<void(const std::string& line)>& take);

}  // namespace racebeam
