// The words of ray interval tracing, each explained once: `racebeam explain --word` and the README
// show this table.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct Word {
  const char* word;
  const char* meaning;  ///< half a sentence
  const char* section;  ///< of docs/contract.md; empty: not of the hardware
};

/// All of them, each after the words that it needs.
const std::vector<Word>& glossary();

/// A word, in any case, or its plural. Throws UsageError that names the nearest.
const Word& glossary_word(const std::string& word);

/// One line of the README's table, without the newline.
std::string word_row(const Word& word);

/// What `racebeam explain --word` prints of some words.
std::string words_text(const std::vector<Word>& words);

}  // namespace racebeam
