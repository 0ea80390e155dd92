// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/glossary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "tb/base/nearest.h"

namespace racebeam {

namespace {

std::string lower(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(letter));
  return text;
}

}  // namespace

const std::vector<Word>& glossary() {
  static const std::vector<Word> words = {
      {"beam", "the pixel that the screen is being sent in this clock", "5.1"},
      {"ray", "the direction from the camera through a pixel: three numbers, called dr", "8"},
      {"room", "a box along the axes; rays are followed from the room of the camera", "12"},
      {"half size", "half the edge of a room, along each axis", "12"},
      {"face", "one of the six sides of a room, named by its axis and direction", "11.2"},
      {"portal", "the part of a face behind which there is another room", "11.2"},
      {"depth", "portals that a ray has passed; behind the eighth everything is a wall", "11.5"},
      {"corner", "the corner of a room whose edges a question asks about, from the camera", "11.1"},
      {"decision", "the answer to one question: on which side of an edge the ray passes", "11.3"},
      {"level", "which of the questions of a room: 6, 7 its face; 0 to 3 the portal in it", "11.2"},
      {"decision tree", "the order in which questions follow from answers, room by room", "11.5"},
      {"interval", "neighbouring pixels of a line with the same answers so far", "9.4"},
      {"bisection", "the search for the pixel after which an answer changes", "9.5"},
      {"interval stack", "intervals to the right, put aside until the left part is done", "10.1"},
      {"face stack", "the faces passed on the way, to find back out of the rooms", "10.2"},
      {"return", "the way back to where the youngest interval put aside goes on", "9.8"},
      {"restart", "beginning at the top of the tree again, as the stack lost its entry", "9.8"},
      {"FIFO", "the queue of finished intervals, length and colour, that feeds the beam", "14"},
      {"stall", "a clock in which the tracer waits for room in the FIFO", "4.2"},
      {"starved", "of a pixel: the beam was there before its interval, and shows what it has",
       "14"},
      {"hurry", "while the beam starves, giving up short intervals as they are", "9.3"},
      {"give-up", "an interval ended by the hurry rule, shown dark", "9.3"},
      {"slack", "clocks from a pixel being known to its being shown; 0 or less: the beam won", ""},
      {"cost", "decisions that were spent on a pixel", ""},
      {"interlace", "odd lines show the camera one step back", "5.4"},
      {"ray pattern", "bits of the ray shown as colours, instead of rooms", "17.4"},
      {"knob", "a size or rule of the chip that --set changes", "3"},
      {"twin", "the same unit in the other language, SystemC or SystemVerilog", ""},
      {"lockstep", "a unit's twin run beside it in every clock, its outputs compared", ""},
      {"golden tracer", "a plain tracer that shares no code with the chip, to judge it", ""},
  };
  return words;
}

const Word& glossary_word(const std::string& word) {
  const auto is = [asked = lower(word)](const Word& one) {
    return lower(one.word) == asked || lower(one.word) + "s" == asked;
  };
  const auto found = std::find_if(glossary().begin(), glossary().end(), is);
  if (found != glossary().end()) return *found;
  std::vector<std::string> known;
  for (const Word& one : glossary()) known.emplace_back(one.word);
  throw unknown_name("word", word, known);
}

std::string word_row(const Word& word) {
  return fmt::format("| {} | {} | {} |", word.word, word.meaning, word.section);
}

std::string words_text(const std::vector<Word>& words) {
  std::string text;
  for (const Word& one : words)
    text += fmt::format("{:<14}  {}{}\n", one.word, one.meaning,
                        *one.section ? fmt::format(" (contract {})", one.section) : "");
  return text;
}

}  // namespace racebeam
