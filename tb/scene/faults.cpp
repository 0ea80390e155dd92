// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/faults.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace racebeam {

namespace {

std::string listed(std::vector<Fault> faults, const std::string& file, const std::string& kind) {
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  std::string text;
  for (const Fault& fault : faults) {
    text += file;
    if (fault.place.line > 0)
      text += ":" + std::to_string(fault.place.line) + ":" + std::to_string(fault.place.column);
    text += ": " + kind + fault.what + "\n";
    if (!fault.help.empty()) text += "  help: " + fault.help + "\n";
  }
  return text;
}

}  // namespace

void Faults::add(Place place, std::string what, std::string help) {
  if (count_++ < Kept) kept_.push_back({place, std::move(what), std::move(help)});
}

void Faults::warn(Place place, std::string what, std::string help) {
  if (warnings_.size() < Kept) warnings_.push_back({place, std::move(what), std::move(help)});
}

std::string Faults::text(const std::string& file) const {
  std::string text = listed(kept_, file, "");
  if (count_ > Kept) text += file + ": and " + std::to_string(count_ - Kept) + " more faults\n";
  return text;
}

std::string Faults::warnings(const std::string& file) const {
  return listed(warnings_, file, "warning: ");
}

std::string quoted(std::string_view text) {
  constexpr std::size_t Longest = 40;
  std::string safe = "'";
  for (const char c : text.substr(0, Longest)) {
    const unsigned char byte = static_cast<unsigned char>(c);
    safe += byte < 32 || byte >= 127 ? '?' : c;
  }
  return safe + (text.size() > Longest ? "...'" : "'");
}

}  // namespace racebeam
