// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/packed.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <new>
#include <stdexcept>

namespace racebeam {

namespace {

// A run: the colour, with the length above it if that fits into two bits; else the length follows,
// seven bits a byte, the lowest first, the highest bit set in all bytes but the last.
constexpr int ColourBits = 6, ShortRun = 4;
constexpr std::uint8_t ColourMask = (1 << ColourBits) - 1;
constexpr int LengthBits7 = 7;
constexpr std::uint8_t More = 1 << LengthBits7;

[[noreturn]] void damaged() { throw std::runtime_error("a packed picture is damaged"); }

}  // namespace

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
    damaged();
  return result;
}

std::string packed_colours(const std::vector<std::uint8_t>& colours) {
  std::string runs;
  for (auto at = colours.begin(); at != colours.end();) {
    const auto end = std::find_if(at, colours.end(), [&](std::uint8_t one) { return one != *at; });
    auto length = static_cast<std::size_t>(end - at);
    if (length < ShortRun) {
      runs += static_cast<char>(*at | length << ColourBits);
    } else {
      runs += static_cast<char>(*at);
      for (; length >= More; length >>= LengthBits7) runs += static_cast<char>(length | More);
      runs += static_cast<char>(length);
    }
    at = end;
  }
  return runs;
}

void unpack_colours(std::string_view runs, std::vector<std::uint8_t>& colours) {
  std::size_t done = 0;
  for (std::size_t at = 0; at < runs.size();) {
    const auto first = static_cast<std::uint8_t>(runs[at++]);
    std::size_t length = first >> ColourBits;
    for (int shift = 0; length == 0 || shift > 0;) {
      if (at == runs.size() || shift > 4 * LengthBits7) damaged();
      const auto byte = static_cast<std::uint8_t>(runs[at++]);
      length |= static_cast<std::size_t>(byte & (More - 1)) << shift;
      shift = byte & More ? shift + LengthBits7 : 0;
      if (shift == 0 && length == 0) damaged();
    }
    if (length > colours.size() - done) damaged();
    std::fill_n(colours.begin() + static_cast<std::ptrdiff_t>(done), length, first & ColourMask);
    done += length;
  }
  if (done != colours.size()) damaged();
}

// The size is that of a screen at most: a head that says more is damaged.
std::string packed_picture(const PackedPicture& picture) {
  std::string head;
  for (const int number : {picture.width, picture.height, picture.bits})
    head += std::to_string(number) + ' ';
  return head +
         packed({reinterpret_cast<const char*>(picture.colours.data()), picture.colours.size()});
}

PackedPicture unpacked_picture(std::string_view bytes) {
  constexpr int MostColumns = 4096, MostBits = 10;
  PackedPicture picture;
  const char *at = bytes.data(), *const end = at + bytes.size();
  for (int* const number : {&picture.width, &picture.height, &picture.bits}) {
    const auto [rest, error] = std::from_chars(at, end, *number);
    if (error != std::errc() || rest == end || *number < 1 || *number > MostColumns) damaged();
    at = rest + 1;
  }
  if (picture.bits > MostBits) damaged();
  const std::string colours =
      unpacked({at, static_cast<std::size_t>(end - at)}, picture.pixels() * picture.colour_bytes());
  picture.colours.assign(colours.begin(), colours.end());
  return picture;
}

std::string text_of_numbers(const std::vector<std::int64_t>& numbers) {
  constexpr std::size_t Longest = 21;  // with its space
  std::string text(numbers.size() * Longest, ' ');
  char* end = text.data();
  for (const std::int64_t number : numbers) {
    if (end != text.data()) *end++ = ' ';
    end = std::to_chars(end, text.data() + text.size(), number).ptr;
  }
  text.resize(static_cast<std::size_t>(end - text.data()));
  return text;
}

std::vector<std::int64_t> numbers_of_text(std::string_view text) {
  std::vector<std::int64_t> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    if (!numbers.empty() && *at++ != ' ') throw std::runtime_error("no space between two numbers");
    const auto [next, error] = std::from_chars(at, end, numbers.emplace_back());
    if (error != std::errc()) throw std::runtime_error("what should be a number is none");
    at = next;
  }
  return numbers;
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
