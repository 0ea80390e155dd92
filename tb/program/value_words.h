// What may stand in the place of a type of the help, such as LEVEL: for completion.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct ValueWords {
  enum Paths { None, Files, Folders };
  std::vector<std::string> words;  ///< whole ones, with what stands before `=` or a comma
  Paths paths = None;              ///< paths may stand there, too
};

/// For a word that begins with `text`; of a type that has no words none.
ValueWords value_words(const std::string& type, const std::string& text);

/// The types that have words.
std::vector<std::string> types_with_words();

}  // namespace racebeam
