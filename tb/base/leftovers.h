// What a program that was killed has left behind: files under temporary names.
//
// A temporary name holds a mark of its owner: the machine, or what looks like one to its processes,
// and the process. Files of an owner that is dead go when the next one comes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// The mark of this process, such as "8f3a01c2-4711".
std::string owner_mark();

/// Removes the files of dead owners on this machine from `folder`: their names are hidden and have
/// the mark between a dot and a dash, and a number. Once in a process for each folder.
void remove_leftovers(const std::string& folder);

}  // namespace racebeam
