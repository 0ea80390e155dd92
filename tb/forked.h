// Work in a process of its own, whose answer is a text.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace racebeam {

/// Runs `work` in a child and returns what it returns. An exception there is thrown here as a
/// std::runtime_error of the same text.
std::string forked(const std::function<std::string()>& work);

/// Writes all bytes to a pipe; false if its reader is gone.
bool write_all(int file, const std::string& bytes);

}  // namespace racebeam
