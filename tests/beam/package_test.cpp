// rtl/base/racebeam_pkg.sv says what sc/base/constants.h and sc/beam/codes.h say.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "tb/base/text_pattern.h"

namespace racebeam {
namespace {

/// Name and value, as they are written.
using Table = std::map<std::string, std::string>;

std::string text_of(const std::string& file) {
  std::ifstream in(RACEBEAM_SOURCE_DIR "/" + file);
  return TextPattern("//[^\n]*")
      .replaced(std::string(std::istreambuf_iterator<char>(in), {}),
                [](const TextPattern::Groups&) { return ""; });
}

Table found(const std::string& text, const std::string& pattern) {
  Table all;
  for (const TextPattern::Groups& constant : TextPattern(pattern).all(text))
    EXPECT_TRUE(all.emplace(constant[1], constant[2]).second) << constant[1] << " twice";
  return all;
}

/// "corner_op.CornerHold": "0"; `declared` has the enum's name and then its body, in some order.
Table enumerators(const std::string& text, const std::string& declared, int name, int body) {
  Table all;
  for (const TextPattern::Groups& whole : TextPattern(declared).all(text))
    for (const auto& [each, value] : found(whole[body], R"((\w+) = (?:\d'd)?(\d+))"))
      all[whole[name] + "." + each] = value;
  return all;
}

TEST(Package, HasTheConstantsOfTheModel) {
  const Table rtl =
      found(text_of("rtl/base/racebeam_pkg.sv"), R"(localparam int (\w+) = ([^;]+);)");
  const Table model = found(text_of("sc/base/constants.h"), R"(constexpr int (\w+) = ([^;]+);)");
  EXPECT_GT(rtl.size(), 30u);
  for (const auto& [name, value] : rtl) {
    ASSERT_TRUE(model.count(name)) << name << " is not in constants.h";
    EXPECT_EQ(value, model.at(name)) << name;
  }
}

TEST(Package, HasTheCodesOfTheModel) {
  const Table rtl = enumerators(text_of("rtl/base/racebeam_pkg.sv"),
                                R"(typedef enum [^{]*\{([^}]*)\} (\w+);)", 2, 1);
  const Table model = enumerators(text_of("sc/beam/codes.h"), R"(enum (\w+) \{([^}]*)\};)", 1, 2);
  EXPECT_EQ(rtl.size(), 15u);
  EXPECT_EQ(rtl, model);
}

}  // namespace
}  // namespace racebeam
