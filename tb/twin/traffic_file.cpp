// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/traffic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "tb/base/errors.h"
#include "tb/twin/traffic_codec.h"
#include "tb/twin/traffic_head.h"

namespace racebeam {

namespace {

constexpr std::uint64_t FootMagic = 0x31646e6566617274;  // "trafend1"
constexpr std::size_t SumBytes = sizeof(std::uint64_t);

/// In front of a block's bytes; the sum is of the rest of it, and of them.
struct BlockHead {
  std::uint64_t sum, first;
  std::uint32_t clocks, is_private;
  std::uint64_t size;
};
struct Foot {
  std::uint64_t magic, index_at, sum;
};

template <class T>
std::string bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}
template <class T>
T value_at(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

std::uint64_t sum_of(std::string_view bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

std::string with_sum(const std::string& bytes) { return bytes + bytes_of(sum_of(bytes)); }

/// The sum at the end of what with_sum() made is right.
bool is_sound(std::string_view bytes) {
  if (bytes.size() < SumBytes) return false;
  const std::size_t size = bytes.size() - SumBytes;
  return sum_of(bytes.substr(0, size)) == value_at<std::uint64_t>(bytes.data() + size);
}

}  // namespace

TrafficWriter::TrafficWriter(const std::string& path, const TrafficHead& head)
    : file_(path), ports_(head.ports.size()) {
  write(with_sum(head_text(head)));
}

void TrafficWriter::write(const std::string& bytes) {
  file_.write(bytes.data(), bytes.size());
  bytes_ += bytes.size();
}

void TrafficWriter::add(const std::uint64_t* row, bool is_private) {
  if (is_private != block_.is_private || block_.values.size() == BlockClocks * ports_) flush();
  if (block_.values.empty()) {
    block_.first = clocks_;
    block_.is_private = is_private;
  }
  block_.values.insert(block_.values.end(), row, row + ports_);
  clocks_ += !is_private;
}

void TrafficWriter::flush() {
  if (block_.values.empty()) return;
  const std::string packed = pack_traffic(block_.values, ports_);
  const BlockHead head{0, block_.first, static_cast<std::uint32_t>(block_.values.size() / ports_),
                       block_.is_private, packed.size()};
  const std::string summed = bytes_of(head).substr(SumBytes) + packed;
  index_ +=
      bytes_of(bytes_) + bytes_of(head.first) + bytes_of(head.clocks) + bytes_of(head.is_private);
  ++blocks_;
  write(bytes_of(sum_of(summed)) + summed);
  block_.values.clear();
}

void TrafficWriter::commit() {
  flush();
  const std::uint64_t at = bytes_, marks = marks_.size();
  std::string index = bytes_of(blocks_) + index_ + bytes_of(marks);
  for (const TrafficMark& mark : marks_) index += bytes_of(mark.clock) + bytes_of(mark.frame);
  write(with_sum(index));
  const Foot foot{FootMagic, at, 0};
  write(with_sum(bytes_of(foot).substr(0, sizeof foot - SumBytes)));
  file_.commit(bytes_);
}

TrafficFile::TrafficFile(const std::string& path) : path_(path) {
  map();
  try {
    read_head();
    read_index();
    check_blocks();
  } catch (...) {
    munmap(const_cast<char*>(data_), size_);
    throw;
  }
}

TrafficFile::~TrafficFile() { munmap(const_cast<char*>(data_), size_); }

void TrafficFile::refuse(const std::string& why) const {
  throw UsageError(path_ + ": " + why + "; make it again with `racebeam capture`");
}

void TrafficFile::map() {
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw UsageError("cannot read " + path_ + ": " + std::strerror(errno));
  struct stat facts {};
  const bool good = fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_size > 0;
  size_ = good ? static_cast<std::size_t>(facts.st_size) : 0;
  void* data = good ? mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0) : MAP_FAILED;
  close(file);
  if (data == MAP_FAILED) refuse(good ? "it cannot be mapped" : "it is empty, or no file");
  data_ = static_cast<const char*>(data);
}

void TrafficFile::read_head() {
  const std::string_view all(data_, size_);
  const std::string end = std::string("\n") + TrafficHeadEnd;
  if (all.substr(0, std::strlen(TrafficMagic)) != TrafficMagic)
    refuse("it does not begin as port traffic does");
  const auto at = all.find(end);
  head_end_ = at == std::string_view::npos ? size_ : at + end.size() + SumBytes;
  if (at == std::string_view::npos || head_end_ > size_) refuse("it is cut short in its head");
  try {
    // Another version may have another sum.
    head_ = head_of(std::string(all.substr(0, head_end_ - SumBytes)));
  } catch (const std::runtime_error& error) {
    refuse(error.what());
  }
  if (!is_sound(all.substr(0, head_end_))) refuse("its head is damaged");
}

void TrafficFile::read_index() {
  const std::size_t foot_at = size_ - std::min(size_, sizeof(Foot));
  const std::string_view foot(data_ + foot_at, size_ - foot_at);
  if (foot_at < head_end_ || value_at<Foot>(foot.data()).magic != FootMagic || !is_sound(foot))
    refuse("its end is missing or damaged: it is cut short, or something follows it");
  index_at_ = value_at<Foot>(foot.data()).index_at;
  if (index_at_ < head_end_ || index_at_ > foot_at ||
      !is_sound({data_ + index_at_, foot_at - index_at_}))
    refuse("its index is damaged");
  const char* at = data_ + index_at_;
  const auto take = [&](auto& value) {
    if (at + sizeof value > data_ + foot_at) refuse("its index is damaged");
    std::memcpy(&value, at, sizeof value);
    at += sizeof value;
  };
  std::uint64_t number = 0;
  for (take(number); number > 0; --number) {
    Entry entry{};
    take(entry.offset), take(entry.first), take(entry.clocks), take(entry.is_private);
    blocks_.push_back(entry);
    clocks_ += entry.is_private ? 0 : entry.clocks;
  }
  for (take(number); number > 0; --number) {
    TrafficMark mark{};
    take(mark.clock), take(mark.frame);
    marks_.push_back(mark);
  }
}

void TrafficFile::check_blocks() const {
  std::uint64_t at = head_end_, first = 0;
  for (const Entry& entry : blocks_) {
    const std::string where = fmt::format("its block of {} clocks from clock {} on is damaged",
                                          entry.clocks, entry.first);
    if (entry.clocks > TrafficWriter::BlockClocks || entry.offset != at ||
        at + sizeof(BlockHead) > index_at_ || entry.first != first)
      refuse(where);
    const auto head = value_at<BlockHead>(data_ + at);
    if (head.size > index_at_ - at - sizeof head || head.clocks != entry.clocks ||
        head.is_private != entry.is_private || head.first != first ||
        sum_of({data_ + at + SumBytes, sizeof head - SumBytes + head.size}) != head.sum)
      refuse(where);
    at += sizeof head + head.size;
    first += entry.is_private ? 0 : entry.clocks;
  }
  if (at != index_at_) refuse("it has bytes that belong to no block");
}

bool TrafficFile::next(TrafficBlock& block) {
  if (next_ >= blocks_.size()) return false;
  const Entry& entry = blocks_[next_++];
  const char* at = data_ + entry.offset;
  const auto head = value_at<BlockHead>(at);
  block.first = entry.first;
  block.is_private = entry.is_private != 0;
  if (!unpack_traffic({at + sizeof head, head.size}, head_.ports.size(), entry.clocks,
                      block.values))
    refuse(fmt::format("its block from clock {} on does not unpack", entry.first));
  return true;
}

void TrafficFile::seek(std::uint64_t clock) {
  const auto after = std::upper_bound(
      blocks_.begin(), blocks_.end(), clock,
      [](std::uint64_t sought, const Entry& entry) { return sought < entry.first; });
  next_ = static_cast<std::size_t>(after - blocks_.begin());
  if (next_ > 0) --next_;
}

}  // namespace racebeam
