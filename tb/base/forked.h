// Work in a process of its own, whose answer is a text.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace racebeam {

/// Says how.
class ChildDied : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

/// Runs `work` in a child and returns what it returns. An exception there is thrown here with
/// the same text: RtlError, UsageError (an OutputError too), MissingTool, Interrupted, others as
/// std::runtime_error; a child that dies as ChildDied. A child is told of an
/// interrupt, and has the time to answer.
std::string forked(const std::function<std::string()>& work);

/// Writes all bytes to a pipe; false if its reader is gone.
bool write_all(int file, const std::string& bytes);

}  // namespace racebeam
