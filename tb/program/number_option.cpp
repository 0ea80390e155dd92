// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/number_option.h"

#include <charconv>
#include <system_error>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

long long number_of(const std::string& option, const std::string& text, const std::string& range) {
  const char* first = text.data() + (text.size() > 1 && text[0] == '+');
  const char* last = text.data() + text.size();
  long long value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc::invalid_argument || end != last)
    throw UsageError(option + " '" + text + "' is not a number; " + range);
  if (error != std::errc()) throw UsageError(option + " " + text + " is out of range; " + range);
  return value;
}

}  // namespace

CheckWord is_number(const std::string& option, const std::string& range) {
  return [=](const std::string& text) {
    number_of(option, text, range);
    return std::string();
  };
}

CheckWord is_number_in(const std::string& option, long long low, long long high) {
  const std::string range = std::to_string(low) + ".." + std::to_string(high);
  return [=](const std::string& text) {
    const long long value = number_of(option, text, range);
    if (value < low || value > high)
      throw UsageError(option + " " + text + " is out of range; " + range);
    return std::string();
  };
}

}  // namespace racebeam
