// rtl/sphere/sphere_pkg.sv says what sc/sphere/codes.h and sc/store/store_knobs.h say.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

namespace racebeam {
namespace {

/// Name and value, as they are written.
using Table = std::map<std::string, std::string>;

std::string text_of(const std::string& file) {
  std::ifstream in(RACEBEAM_SOURCE_DIR "/" + file);
  return std::regex_replace(std::string(std::istreambuf_iterator<char>(in), {}),
                            std::regex("//[^\n]*"), "");
}

Table found(const std::string& text, const std::string& pattern) {
  Table all;
  const std::regex constant(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), constant), end; at != end; ++at)
    EXPECT_TRUE(all.emplace((*at)[1], (*at)[2]).second) << (*at)[1] << " twice";
  return all;
}

TEST(SpherePackage, HasTheConstantsOfTheModel) {
  const Table rtl =
      found(text_of("rtl/sphere/sphere_pkg.sv"), R"(localparam int (\w+) = ([^;]+);)");
  const Table model = found(text_of("sc/sphere/codes.h") + text_of("sc/store/store_knobs.h"),
                            R"(constexpr int (\w+) = ([^;]+);)");
  EXPECT_GE(rtl.size(), 18u);
  for (const auto& [name, value] : rtl) {
    ASSERT_TRUE(model.count(name)) << name << " is not in the model";
    EXPECT_EQ(value, model.at(name)) << name;
  }
}

TEST(SpherePackage, HasTheCodesOfTheModel) {
  const std::string code = R"(((?:Sphere|Vector|Shade)\w+) = (?:\d'd)?(\d+)\s*[,}\n])";
  const Table rtl = found(text_of("rtl/sphere/sphere_pkg.sv"), code);
  EXPECT_EQ(rtl.size(), 28u + 3u + 8u);
  EXPECT_EQ(rtl, found(text_of("sc/sphere/codes.h"), code));
}

}  // namespace
}  // namespace racebeam
