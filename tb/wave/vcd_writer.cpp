// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/vcd_writer.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

namespace racebeam {

namespace {

/// Identifier code: printable characters, the shortest first.
std::string code(int signal) {
  constexpr int First = '!', Codes = '~' - '!' + 1;
  std::string text;
  for (; signal >= 0; signal = signal / Codes - 1)
    text += static_cast<char>(First + signal % Codes);
  return text;
}

std::vector<std::string> parts(const std::string& scope) {
  std::vector<std::string> names;
  std::istringstream in(scope);
  for (std::string name; std::getline(in, name, '.');) names.push_back(name);
  return names;
}

/// Leaves the scopes of `from` that are not of `to`, and enters the others.
std::string move(const std::vector<std::string>& from, const std::vector<std::string>& to) {
  std::size_t same = 0;
  while (same < from.size() && same < to.size() && from[same] == to[same]) ++same;
  std::string text;
  for (std::size_t n = same; n < from.size(); ++n) text += "$upscope $end\n";
  for (std::size_t n = same; n < to.size(); ++n) text += "$scope module " + to[n] + " $end\n";
  return text;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; }

/// Without what would end a comment or its line.
std::string plain(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '$' || is_control(c); }, '_');
  return text;
}

}  // namespace

int VcdWriter::add_signal(const std::string& scope, const std::string& name, int bits) {
  if (started_) throw std::logic_error(name + " comes after the first change");
  const int signal = static_cast<int>(signals_.size());
  signals_.push_back({bits, code(signal) + "\n"});
  names_.push_back({scope, name, signal});
  return signal;
}

int VcdWriter::add(const std::string& scope, const std::string& name, int bits) {
  if (bits < 1 || bits > 64) throw std::invalid_argument(name + ": a signal has 1 to 64 bits");
  return add_signal(scope, name, bits);
}

int VcdWriter::add_text(const std::string& scope, const std::string& name) {
  return add_signal(scope, name, 0);
}

void VcdWriter::alias(const std::string& scope, const std::string& name, int signal) {
  if (started_) throw std::logic_error(name + " comes after the first change");
  names_.push_back({scope, name, signal});
}

// To the time of the next change.
void VcdWriter::step(std::uint64_t time) {
  constexpr std::size_t Enough = 1 << 16;
  if (file_ && changes_.size() > Enough) {
    flush();
  }
  if (time == time_ && started_) return;
  if (time < time_) throw std::logic_error("time runs backwards");
  if (dumping_) changes_ += "$end\n";
  char text[24] = "#";
  char* const end = std::to_chars(text + 1, text + sizeof text, time).ptr;
  *end = '\n';
  changes_.append(text, end + 1);
  dumping_ = !started_;
  if (dumping_) changes_ += "$dumpvars\n";
  started_ = true;
  time_ = time;
}

void VcdWriter::write(std::uint64_t time, Signal& signal, std::uint64_t value) {
  signal.known = true;
  signal.value = value;
  step(time);
  if (signal.bits == 1) {
    (changes_ += value & 1 ? '1' : '0') += signal.ending;
    return;
  }
  char digits[66];  // "b", up to 64, " "; a reader fills in the zeros to the left
  char* to = digits + sizeof digits;
  *--to = ' ';
  value &= ~std::uint64_t{0} >> (64 - signal.bits);
  do *--to = static_cast<char>('0' + (value & 1));
  while (value >>= 1);
  *--to = 'b';
  changes_.append(to, digits + sizeof digits) += signal.ending;
}

void VcdWriter::change(std::uint64_t time, int signal, const std::string& word) {
  Signal& s = signals_[static_cast<std::size_t>(signal)];
  if (s.known && s.word == word) return;
  s.known = true;
  s.word = word;
  step(time);
  std::string shown = word.empty() ? "_" : word;
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c == ' ' || is_control(c); }, '_');
  changes_ += "s" + shown + " " + s.ending;
}

std::string VcdWriter::header(const std::string& comment) const {
  std::vector<const Name*> order;
  for (const Name& name : names_) order.push_back(&name);
  std::stable_sort(order.begin(), order.end(),
                   [](const Name* a, const Name* b) { return a->scope < b->scope; });
  std::string text = "$comment " + plain(comment) + " $end\n$timescale 1 ps $end\n";
  std::vector<std::string> place;
  for (const Name* n : order) {
    const int wide = bits(n->signal);
    const auto to = parts(n->scope);
    text += move(place, to);
    place = to;
    text += (wide ? "$var wire " + std::to_string(wide) : "$var string 1") + " " + code(n->signal) +
            " " + n->name + (wide > 1 ? " [" + std::to_string(wide - 1) + ":0]" : "") + " $end\n";
  }
  return text + move(place, {}) + "$enddefinitions $end\n";
}

std::string VcdWriter::ending(std::uint64_t end) const {
  return std::string(dumping_ ? "$end\n" : "") +
         (end > time_ ? "#" + std::to_string(end) + "\n" : "");
}

std::string VcdWriter::text(const std::string& comment, std::uint64_t end) const {
  return header(comment) + changes_ + ending(end);
}

void VcdWriter::stream(OutputFile& file, const std::string& comment) {
  file_ = &file;
  comment_ = comment;
}

void VcdWriter::finish(std::uint64_t end) {
  changes_ += ending(end);
  flush();
}

void VcdWriter::flush() {
  if (!headed_) changes_.insert(0, header(comment_));
  headed_ = true;
  file_->write(changes_.data(), changes_.size());
  written_ += changes_.size();
  changes_.clear();
}

}  // namespace racebeam
