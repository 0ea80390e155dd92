// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/vcd_reader.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Nanosecond = 1'000'000;  // in femtoseconds

/// The whole of `text` as a number.
template <class Number>
bool is_number(const std::string& text, Number& number) {
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  return error == std::errc{} && end == last;
}

bool is_digits(const std::string& value) {
  return !value.empty() && value.find_first_not_of("01xzhuwl-") == std::string::npos;
}

// IEEE 1364-2005, table 18-2: x and z go on to the left, and 0 does before 0 and 1.
std::string shortest(std::string digits, int bits) {
  const auto width = static_cast<std::size_t>(bits);
  if (digits.size() > width) digits.erase(0, digits.size() - width);
  std::size_t spare = 0;
  for (; spare + 1 < digits.size(); ++spare) {
    const char digit = digits[spare], next = digits[spare + 1];
    if (digit == '1' || !(digit == next || (digit == '0' && next == '1'))) break;
  }
  return digits.substr(spare);
}

/// Whether "[7:0]" is the range of a whole vector.
bool is_whole(const std::string& range) {
  const auto colon = range.find(':');
  if (colon == std::string::npos) return false;
  return range.substr(colon) == ":0]" || range.substr(0, colon) == "[0";
}

}  // namespace

VcdReader::VcdReader(const std::string& path)
    : VcdReader(std::make_unique<std::ifstream>(path), path) {}

VcdReader::VcdReader(std::unique_ptr<std::istream> in, const std::string& name)
    : name_(name), in_(std::move(in)), unit_(Nanosecond) {
  if (!*in_) throw UsageError("cannot read " + name);
  read_header();
  read_changes();
  if (!next_ && !coming_.empty()) next_ = 0;
}

void VcdReader::broken(const std::string& what) const {
  throw UsageError(name_ + " is no value change dump: " + what);
}

// The words up to $end.
std::vector<std::string> VcdReader::section() {
  std::vector<std::string> words;
  std::string word;
  while (*in_ >> word && word != "$end") words.push_back(word);
  if (!*in_) broken("$end is missing");
  return words;
}

void VcdReader::read_header() {
  std::vector<std::string> scopes;
  for (std::string word; *in_ >> word;) {
    if (word == "$var") {
      read_variable(scopes);
    } else if (word == "$timescale") {
      read_unit();
    } else if (word == "$scope") {
      const auto words = section();
      if (words.size() != 2) broken("a $scope of " + std::to_string(words.size()) + " words");
      scopes.push_back(words[1]);
    } else if (word == "$upscope") {
      if (scopes.empty()) broken("$upscope without $scope");
      scopes.pop_back();
      section();
    } else {
      if (word[0] != '$') broken("'" + word + "' where a section begins");
      section();  // $date, $version, $comment
      if (word == "$enddefinitions") return;
    }
  }
  broken("$enddefinitions is missing");
}

// "1 ps", "100us".
void VcdReader::read_unit() {
  std::string text;
  for (const std::string& word : section()) text += word;
  const std::size_t digits = std::min(text.find_first_not_of("01"), text.size());
  const std::string number = text.substr(0, digits);
  unit_ = number == "1" ? 1 : number == "10" ? 10 : number == "100" ? 100 : 0;
  for (const char* name : {"fs", "ps", "ns", "us", "ms", "s"}) {
    if (text.substr(digits) == name && unit_) return;
    unit_ *= 1000;
  }
  broken("a time scale of '" + text + "'");
}

void VcdReader::read_variable(const std::vector<std::string>& scopes) {
  const auto words = section();  // kind, bits, code, name, and a range perhaps
  if (words.size() < 4) broken("a $var of " + std::to_string(words.size()) + " words");
  const std::string &kind = words[0], &code = words[2];
  std::string path, name = words[3], range;
  for (const std::string& scope : scopes) path += scope + ".";
  for (std::size_t n = 4; n < words.size(); ++n) range += words[n];
  if (const auto at = name.rfind('['); range.empty() && at != std::string::npos) {
    range = name.substr(at);
    name.erase(at);
  }
  path += is_whole(range) ? name : name + range;

  const auto [at, is_new] = codes_.emplace(code, static_cast<int>(bits_.size()));
  if (is_new) {
    int bits = 0;
    if (!is_number(words[1], bits) || bits < 0) broken("a width of '" + words[1] + "'");
    const bool in_words = kind == "string" || kind == "real" || kind == "realtime";
    bits_.push_back(in_words ? 0 : std::max(bits, 1));
    values_.emplace_back();
  }
  auto place = signals_.emplace(path, at->second);
  while (!place.second && place.first->second != at->second)
    place = signals_.emplace(path += "'", at->second);
  if (place.second) paths_.push_back(path);
}

// "#123".
std::uint64_t VcdReader::time_of(const std::string& word) const {
  std::uint64_t time = 0;
  if (!is_number(word.substr(1), time)) broken("a time of '" + word + "'");
  return time;
}

// The changes of next_, up to the next time.
void VcdReader::read_changes() {
  const std::optional<std::uint64_t> now = std::exchange(next_, std::nullopt);
  for (std::string word; *in_ >> word;) {
    if (word[0] == '#') {
      const std::uint64_t time = time_of(word);
      if (now && time < *now) broken("time runs backwards at '" + word + "'");
      if (time == now) continue;
      next_ = time;
      return;
    }
    if (word[0] != '$') read_change(word);
    else if (word != "$end" && word.rfind("$dump", 0) != 0) section();  // $comment
    // The changes in $dumpvars, $dumpoff, $dumpon and $dumpall are changes like others.
  }
}

void VcdReader::read_change(const std::string& word) {
  const char kind = static_cast<char>(std::tolower(static_cast<unsigned char>(word[0])));
  const bool apart = kind == 'b' || kind == 'r' || kind == 's';
  std::string value = apart ? word.substr(1) : word.substr(0, 1), code;
  if (apart) *in_ >> code;
  else code = word.substr(1);
  const auto at = codes_.find(code);
  if (at == codes_.end()) broken("a change of '" + code + "', which it does not declare");
  const auto signal = static_cast<std::size_t>(at->second);
  if (bits_[signal] > 0) {
    for (char& c : value) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!is_digits(value)) broken("a value of '" + word + "'");
    value = shortest(value, bits_[signal]);
  }
  values_[signal] = value;
  coming_.push_back(at->second);
}

const std::vector<int>& VcdReader::advance() {
  changed_.clear();
  if (!next_) return changed_;
  read_changes();
  std::swap(changed_, coming_);
  return changed_;
}

}  // namespace racebeam
