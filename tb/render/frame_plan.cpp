// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/frame_plan.h"

#include <fmt/format.h>

#include <charconv>
#include <set>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

/// One part of a list: "700", or "700-720".
class Part {
 public:
  Part(const std::string& text, int show) : at_(text.data()), end_(at_ + text.size()) {
    first = last = number(text, show);
    if (at_ < end_ && *at_ == '-') {
      ++at_;
      last = number(text, show);
    }
    if (at_ != end_ || last < first) fail(text);
  }
  int first, last;

 private:
  [[noreturn]] static void fail(const std::string& text) {
    throw UsageError(
        fmt::format("--at: '{}' is no frame and no range; write 7223, or 5,700-720", text));
  }
  int number(const std::string& text, int show) {
    long long value = 0;
    const auto read = std::from_chars(at_, end_, value);
    if (read.ec == std::errc::invalid_argument) fail(text);
    if (read.ec != std::errc() || value < 0 || value >= show)
      throw UsageError(
          fmt::format("--at {} is out of range; the scene has the frames 0..{}", text, show - 1));
    at_ = read.ptr;
    return static_cast<int>(value);
  }

  const char* at_;
  const char* end_;
};

}  // namespace

FramePlan::FramePlan(int count, int first, int every, int show)
    : count_(count), first_(first), every_(every), show_(show) {}

FramePlan::FramePlan(const std::string& list, int show)
    : count_(0), first_(0), every_(0), show_(show) {
  std::set<int> known;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    const Part part(list.substr(from, comma - from), show);
    for (int frame = part.first; frame <= part.last; ++frame)
      if (known.insert(frame).second) list_.push_back(frame);
    from = comma + 1;
  }
  count_ = static_cast<int>(list_.size());
  first_ = list_.front();
}

int FramePlan::number(int index) const {
  if (every_ == 0) return list_.at(static_cast<std::size_t>(index));
  return static_cast<int>((first_ + static_cast<long long>(index) * every_) % show_);
}

bool FramePlan::consecutive() const {
  for (int i = 0; i < count_; ++i)
    if (number(i) != first_ + i) return false;
  return true;
}

bool FramePlan::goes_round() const {
  return every_ > 0 && first_ + static_cast<long long>(count_ - 1) * every_ >= show_;
}

}  // namespace racebeam
