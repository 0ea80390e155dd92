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

struct Head {
  std::size_t variables, inputs, registers, outputs, gates;
};

Head head_of(const std::string& line) {
  Head head{};
  std::string kind;
  std::size_t others = 0;
  std::istringstream words(line);
  if (!(words >> kind >> head.variables >> head.inputs >> head.registers >> head.outputs >>
        head.gates) ||
      kind != "aig" || words >> others)
    refuse();
  return head;
}

void write_number(std::string& out, Literal value) {
  for (; value > Digit; value >>= DigitBits) out += static_cast<char>((value & Digit) | More);
  out += static_cast<char>(value);
}

}  // namespace

std::string with_constant_inputs(const std::string& aiger,
                                 const std::map<std::size_t, bool>& constants) {
  Reader in(aiger);
  std::string out = in.line() + "\n";
  const Head head = head_of(out);
  const auto tied = [&](Literal literal) {
    const std::size_t variable = literal / 2;
    const auto constant = variable == 0 ? constants.end() : constants.find(variable - 1);
    if (constant == constants.end() || variable > head.inputs) return literal;
    return static_cast<Literal>(constant->second) ^ (literal & 1);
  };
  // Of a register its next value, and maybe what it begins with.
  for (std::size_t n = 0; n < head.registers + head.outputs; ++n) {
    std::istringstream words(in.line());
    Literal literal;
    std::string begin;
    if (!(words >> literal)) refuse();
    out += std::to_string(tied(literal));
    if (words >> begin) out += " " + begin;
    out += "\n";
  }
  for (std::size_t n = 0; n < head.gates; ++n) {
    const auto gate = static_cast<Literal>(2 * (head.inputs + head.registers + 1 + n));
    const Literal was_left = gate - in.number(), was_right = was_left - in.number();
    if (was_left >= gate || was_right > was_left) refuse();
    const Literal left = tied(was_left), right = tied(was_right);
    write_number(out, gate - std::max(left, right));
    write_number(out, std::max(left, right) - std::min(left, right));
  }
  return out + in.rest();
}

// Variables keep their numbers: registers come behind the inputs already. Names would be wrong.
std::string without_registers(const std::string& aiger) {
  Reader in(aiger);
  const Head head = head_of(in.line());
  std::string out = "aig";
  for (const std::size_t count : {head.variables, head.inputs + head.registers, std::size_t{0},
                                  head.outputs + head.registers, head.gates})
    out += " " + std::to_string(count);
  out += "\n";
  for (std::size_t n = 0; n < head.registers + head.outputs; ++n) {
    const std::string line = in.line();
    out += line.substr(0, line.find(' ')) + "\n";
  }
  for (std::size_t n = 0; n < head.gates; ++n)
    for (int side = 0; side < 2; ++side) write_number(out, in.number());
  return out;
}

}  // namespace racebeam
