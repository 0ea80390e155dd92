// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/against.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tb/base/console.h"
#include "tb/base/counted.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t Named = 5;  // frames in a message

}  // namespace

void Against::add(int frame, const VgaFrame& picture) {
  if (!reference_) return;
  const ReferenceFrames::Frame* expected = reference_->find(frame);
  if (!expected) {
    missing_.push_back(frame);
    return;
  }
  ++compared_;
  const Difference found{frame, *expected, picture.image_crc, picture.pins_crc};
  if (!found.image_differs() && !found.pins_differ()) ++equal_;
  else if (!first_) first_ = found;
}

bool Against::report(bool quiet) const {
  if (!reference_) return false;
  if (!quiet) print(text());
  if (first_) tell(difference());
  return first_.has_value();
}

std::string Against::text() const {
  std::string text = fmt::format("{} of {} equal {}: {}\n", equal_, counted(compared_, "frame"),
                                 reference_->whose(), reference_->what());
  if (missing_.empty()) return text;
  const std::vector<int> named(missing_.begin(),
                               missing_.begin() + std::min(Named, missing_.size()));
  return text + fmt::format("not compared: {} that it does not have: {}{}\n",
                            counted(static_cast<int>(missing_.size()), "frame"),
                            fmt::join(named, ", "), missing_.size() > Named ? ", ..." : "");
}

std::string Against::difference() const {
  std::string text = fmt::format("frame {} is the first of {} that differ from {}", first_->frame,
                                 compared_ - equal_, reference_->whose());
  const auto add = [&](const char* name, std::optional<std::uint32_t> expected, std::uint32_t got) {
    if (!expected) return;
    text += *expected == got
                ? fmt::format("; {} equal", name)
                : fmt::format("; {}: expected {:08x}, got {:08x}", name, *expected, got);
  };
  add("picture", first_->expected.image, first_->image);
  add("pins", first_->expected.pins, first_->pins);
  return text;
}

std::string Against::json() const {
  if (!reference_) return "";
  Json first;
  if (first_) {
    first["frame"] = first_->frame;
    const auto side = [&](const char* name, std::optional<std::uint32_t> expected,
                          std::uint32_t got) {
      if (expected && *expected != got)
        first[name] = {{"expected", fmt::format("{:08x}", *expected)},
                       {"got", fmt::format("{:08x}", got)}};
    };
    side("image_crc32", first_->expected.image, first_->image);
    side("pins_crc32", first_->expected.pins, first_->pins);
  }
  return Json{{"reference", reference_->name()},
              {"compared", compared_},
              {"equal", equal_},
              {"missing", missing_},
              {"first", first}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace racebeam
