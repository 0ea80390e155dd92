// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/packed.h"

#include <zlib.h>

#include <charconv>
#include <new>
#include <stdexcept>

namespace racebeam {

std::string packed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(result.data()), &size,
               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}

std::string unpacked(std::string_view bytes, std::size_t size) {
  std::string result(size, '\0');
  uLongf got = size;
  if (uncompress(reinterpret_cast<Bytef*>(result.data()), &got,
                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK ||
      got != size)
    throw std::runtime_error("a packed picture is damaged");
  return result;
}

std::string hex_of(std::string_view bytes) {
  constexpr const char* Digits = "0123456789abcdef";
  std::string digits;
  digits.reserve(2 * bytes.size());
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    digits += Digits[value >> 4];
    digits += Digits[value & 15];
  }
  return digits;
}

std::string of_hex(std::string_view digits) {
  std::string bytes;
  bytes.reserve(digits.size() / 2);
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const std::string_view two = digits.substr(i, 2);
    unsigned value = 0;
    const auto [end, error] = std::from_chars(two.data(), two.data() + two.size(), value, 16);
    if (two.size() != 2 || error != std::errc() || end != two.data() + 2)
      throw std::runtime_error("these are no hexadecimal digits");
    bytes += static_cast<char>(value);
  }
  return bytes;
}

}  // namespace racebeam
