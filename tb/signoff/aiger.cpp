// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/aiger.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <vector>

#include "sc/swap/rtl_library.h"

namespace racebeam {

namespace {

// A literal is twice the number of its variable, and one more if it is inverted; variable 0 is the
// constant 0. Inputs are the variables from 1, then come registers, then gates.
using Literal = std::uint32_t;

constexpr unsigned More = 0x80, Digit = 0x7f;  // of a number in a file
constexpr int DigitBits = 7;

[[noreturn]] void refuse() { throw RtlError("yosys has written no AIGER file"); }

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}
  std::string line() {
    const auto end = text_.find('\n', at_);
    if (end == std::string::npos) refuse();
    std::string line = text_.substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }
  Literal number() {
    Literal value = 0;
    for (int shift = 0;; shift += DigitBits) {
      if (at_ == text_.size() || shift > 28) refuse();
      const unsigned byte = static_cast<unsigned char>(text_[at_++]);
      value |= (byte & Digit) << shift;
      if ((byte & More) == 0) return value;
    }
  }
  std::string rest() const { return text_.substr(at_); }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
};

void write_number(std::string& out, Literal value) {
  for (; value > Digit; value >>= DigitBits) out += static_cast<char>((value & Digit) | More);
  out += static_cast<char>(value);
}

}  // namespace

std::string with_constant_inputs(const std::string& aiger,
                                 const std::map<std::size_t, bool>& constants) {
  Reader in(aiger);
  std::string out = in.line() + "\n", kind;
  std::size_t variables, inputs, registers, outputs, gates, others = 0;
  std::istringstream head(out);
  if (!(head >> kind >> variables >> inputs >> registers >> outputs >> gates) || kind != "aig" ||
      head >> others)
    refuse();
  const auto tied = [&](Literal literal) {
    const std::size_t variable = literal / 2;
    const auto constant = variable == 0 ? constants.end() : constants.find(variable - 1);
    if (constant == constants.end() || variable > inputs) return literal;
    return static_cast<Literal>(constant->second) ^ (literal & 1);
  };
  // Of a register its next value, and maybe what it begins with.
  for (std::size_t n = 0; n < registers + outputs; ++n) {
    std::istringstream words(in.line());
    Literal literal;
    std::string begin;
    if (!(words >> literal)) refuse();
    out += std::to_string(tied(literal));
    if (words >> begin) out += " " + begin;
    out += "\n";
  }
  for (std::size_t n = 0; n < gates; ++n) {
    const auto gate = static_cast<Literal>(2 * (inputs + registers + 1 + n));
    const Literal was_left = gate - in.number(), was_right = was_left - in.number();
    if (was_left >= gate || was_right > was_left) refuse();
    const Literal left = tied(was_left), right = tied(was_right);
    write_number(out, gate - std::max(left, right));
    write_number(out, std::max(left, right) - std::min(left, right));
  }
  return out + in.rest();
}

}  // namespace racebeam
