// Child processes that nobody is left with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <string>

namespace racebeam {

/// fork() of a child that is killed when this process ends, however it ends. The child must leave
/// by _exit(): static objects of libraries wait there for threads that were not copied.
pid_t fork_child();

/// Waits for the end of a child; its status as of waitpid().
int wait_for_child(pid_t child);

/// How a child ended that did not end by itself, such as "a process that rendered frames died:
/// Segmentation fault".
std::string death_of(const std::string& what, int status);

/// Throws that: MissingTool if it was killed from outside, UsageError if it has ended with 2,
/// std::runtime_error otherwise.
[[noreturn]] void throw_death(const std::string& what, int status);

}  // namespace racebeam
