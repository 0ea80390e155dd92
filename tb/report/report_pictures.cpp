// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/report_pictures.h"

#include <algorithm>
#include <cstdlib>

#include "tb/base/whole_file.h"
#include "tb/sweep/csv_rows.h"

namespace racebeam {

namespace {

constexpr const char* PngHead = "\x89PNG\r\n\x1a\n";

template <class Things>
std::size_t place_named(const Things& things, const std::string& name) {
  const auto at = std::find_if(things.begin(), things.end(),
                               [&](const auto& thing) { return thing.name == name; });
  return static_cast<std::size_t>(at - things.begin());
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr const char* Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    unsigned bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += i <= count ? Digits[bits >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

ReportPictures report_pictures(const ReportedSweep& sweep, const SweepFolder& folder,
                               std::size_t room) {
  struct Offer {
    ReportPicture picture;
    std::string file;
    bool first;
  };
  std::vector<Offer> offers;
  for (auto& row : csv_rows(whole_file(folder.file("pictures/index.csv")))) {
    const std::size_t point = place_named(sweep.points, row["point"]);
    const std::size_t scene = place_named(sweep.plan.scenes, row["scene"]);
    const std::string& file = row["file"];
    if (point == sweep.points.size() || scene == sweep.plan.scenes.size() ||
        file.find('/') != std::string::npos)
      continue;
    offers.push_back({{point, scene, std::atoi(row["frame"].c_str()), row["why"], ""},
                      file,
                      point == 0 || sweep.points[point].on_front()});
  }
  std::stable_partition(offers.begin(), offers.end(), [](const Offer& one) { return one.first; });
  ReportPictures result;
  std::size_t taken = 0;
  for (Offer& offer : offers) {
    const std::string png = whole_file(folder.file("pictures/" + offer.file));
    if (png.rfind(PngHead, 0) != 0) continue;
    offer.picture.base64 = base64(png);
    if (taken + offer.picture.base64.size() > room) {
      ++result.left_out;
      continue;
    }
    taken += offer.picture.base64.size();
    result.taken.push_back(std::move(offer.picture));
  }
  std::stable_sort(result.taken.begin(), result.taken.end(),
                   [](const auto& a, const auto& b) { return a.point < b.point; });
  return result;
}

}  // namespace racebeam
