// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_fate.h"

#include <cerrno>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* Words[] = {"alive", "found", "equal", "escaped", "undecided"};

}  // namespace

const char* word_of(MutantFate::State state) { return Words[state]; }

std::string line_of(const MutantFate& fate) {
  return Json{{"mutant", fate.number}, {"state", Words[fate.state]}, {"stream", fate.stream},
              {"clock", fate.clock},   {"port", fate.port},          {"note", fate.note}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

MutantFate fate_of(const std::string& line) {
  const Json json = Json::parse(line);
  MutantFate fate;
  fate.number = json.at("mutant");
  const std::string state = json.at("state");
  while (fate.state < MutantFate::Undecided && state != Words[fate.state])
    fate.state = static_cast<MutantFate::State>(fate.state + 1);
  fate.stream = json.at("stream");
  fate.clock = json.at("clock");
  fate.port = json.at("port");
  fate.note = json.at("note");
  return fate;
}

FateFile::FateFile(const std::string& path, const std::string& key) : path_(path) {
  std::istringstream lines(whole_file(path));
  std::string line;
  std::string whole = key + "\n";  // a line that was cut off is left out
  if (std::getline(lines, line) && line == key)
    while (std::getline(lines, line) && !lines.eof()) {
      const MutantFate fate = fate_of(line);
      fates_[fate.number] = fate;
    }
  for (const auto& [number, fate] : fates_) whole += line_of(fate) + "\n";
  write_text(path, whole);
  out_.open(path, std::ios::app);
  if (!out_) throw OutputError(path, errno, "it cannot be opened");
}

void FateFile::add(const MutantFate& fate) {
  fates_[fate.number] = fate;
  out_ << line_of(fate) << std::endl;
  if (!out_) throw OutputError(path_, errno, "is the disk full?");
}

}  // namespace racebeam
