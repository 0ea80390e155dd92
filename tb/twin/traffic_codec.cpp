// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/traffic_codec.h"

#include <zlib.h>

#include <stdexcept>

namespace racebeam {

namespace {

constexpr int Level = 3;  // of zlib: twice as fast as 6, a tenth larger
constexpr int Low = 7;    // bits of a byte of a number; the highest says that more follow
constexpr std::size_t LongestNumber = 10;

void put(std::string& to, std::uint64_t number) {
  for (; number >> Low; number >>= Low) to += static_cast<char>(number | 1u << Low);
  to += static_cast<char>(number);
}

/// Numbers as put() wrote them; `bad` once there was none.
class Numbers {
 public:
  explicit Numbers(const std::string& from) : at_(from.data()), end_(at_ + from.size()) {}
  bool bad() const { return bad_; }
  bool all() const { return at_ == end_; }

  std::uint64_t next() {
    std::uint64_t number = 0;
    for (std::size_t n = 0; n < LongestNumber && at_ < end_; ++n) {
      const auto byte = static_cast<unsigned char>(*at_++);
      number |= std::uint64_t{byte & 0x7fu} << (n * Low);
      if (byte >> Low == 0) return number;
    }
    bad_ = true;
    return 0;
  }

 private:
  const char *at_, *end_;
  bool bad_ = false;
};

// Small numbers of either sign are small ones.
std::uint64_t folded(std::uint64_t difference) {
  return difference << 1 ^ (difference >> 63 ? ~std::uint64_t{0} : 0);
}
std::uint64_t unfolded(std::uint64_t number) {
  return number >> 1 ^ (number & 1 ? ~std::uint64_t{0} : 0);
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Level) != Z_OK)
    throw std::runtime_error("zlib cannot compress");
  packed.resize(size);
  return packed;
}

}  // namespace

// Of each port: the changes, then the clocks between them, then the differences; and in front of
// all how many bytes these are.
std::string pack_traffic(const std::vector<std::uint64_t>& values, std::size_t ports) {
  std::string numbers, differences;
  for (std::size_t port = 0; port < ports; ++port) {
    std::string gaps;
    differences.clear();
    std::uint64_t last = 0, changes = 0;
    std::size_t clock = 0, since = 0;
    for (std::size_t at = port; at < values.size(); at += ports, ++clock) {
      if (values[at] == last) continue;
      put(gaps, clock - since);
      put(differences, folded(values[at] - last));
      last = values[at];
      since = clock;
      ++changes;
    }
    put(numbers, changes);
    numbers += gaps;
    numbers += differences;
  }
  std::string packed;
  put(packed, numbers.size());
  return packed + deflated(numbers);
}

bool unpack_traffic(std::string_view bytes, std::size_t ports, std::size_t clocks,
                    std::vector<std::uint64_t>& values) {
  const std::string all(bytes);
  Numbers head(all);
  const std::uint64_t size = head.next();
  std::string front;
  put(front, size);
  // Each value takes two numbers at most, and each port one more.
  if (head.bad() || size > 2 * LongestNumber * ports * (clocks + 1)) return false;
  std::string text(size, '\0');
  uLongf got = size;
  if (uncompress(reinterpret_cast<Bytef*>(text.data()), &got,
                 reinterpret_cast<const Bytef*>(all.data() + front.size()),
                 all.size() - front.size()) != Z_OK ||
      got != size)
    return false;
  Numbers numbers(text);
  values.assign(ports * clocks, 0);
  std::vector<std::size_t> when;
  for (std::size_t port = 0; port < ports; ++port) {
    const std::uint64_t changes = numbers.next();
    if (numbers.bad() || changes > clocks) return false;
    when.clear();
    for (std::uint64_t n = 0, clock = 0; n < changes; ++n) {
      clock += numbers.next();
      if (numbers.bad() || clock >= clocks) return false;
      when.push_back(static_cast<std::size_t>(clock));
    }
    std::uint64_t value = 0;
    for (std::size_t n = 0; n < when.size(); ++n) {
      value += unfolded(numbers.next());
      const std::size_t end = n + 1 < when.size() ? when[n + 1] : clocks;
      for (std::size_t clock = when[n]; clock < end; ++clock) values[clock * ports + port] = value;
    }
  }
  return !numbers.bad() && numbers.all();
}

}  // namespace racebeam
