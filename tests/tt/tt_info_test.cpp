// Promises of tb/tt/tt_info.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_info.h"

#include <gmock/gmock.h>

#include "tb/base/errors.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

constexpr const char* Good =
    "project:\n  top_module: tt_um_a\n  clock_hz: 25_175_000\n  source_files:\n    - a.v\n    - "
    "b.v\n";

std::string refusal(const std::string& text) {
  try {
    read_tt_info(text, "info.yaml");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(TtInfo, HasTopSourcesAndClock) {
  const TtInfo info = read_tt_info(Good, "info.yaml");
  EXPECT_EQ(info.top, "tt_um_a");
  ASSERT_EQ(info.sources.size(), 2u);
  EXPECT_EQ(info.sources[1].name, "b.v");
  EXPECT_EQ(info.sources[1].line, 6);
  EXPECT_EQ(info.clock_hz, 25'175'000u);
}

TEST(TtInfo, AClockThatIsKnownIsNotLookedFor) {
  const std::string text = "project: {top_module: tt_um_a, source_files: [a.v], clock_hz: fast}\n";
  EXPECT_THAT(refusal(text), HasSubstr("info.yaml:1: project.clock_hz must be the clock in Hz"));
  EXPECT_EQ(read_tt_info(text, "info.yaml", true).clock_hz, 0u);
}

TEST(TtInfo, FaultsHaveTheirLine) {
  EXPECT_THAT(refusal("project:\n  top_module: tt_um_a\n  source_files: a.v\n"),
              HasSubstr("info.yaml:3: project.source_files must be a list"));
  EXPECT_THAT(refusal("project:\n  top_module: a; b\n"), HasSubstr("info.yaml:2:"));
  EXPECT_THAT(refusal("a: [\n"), HasSubstr("the file must be YAML"));
  EXPECT_THAT(refusal(""), HasSubstr("there is no section `project:`"));
}

TEST(TtInfo, AZeroByteInANameIsRefused) {
  EXPECT_THAT(refusal("project:\n  top_module: tt_um_a\n  source_files:\n    - \"a.v\\0.sv\"\n"),
              HasSubstr("info.yaml:4: project.source_files: a zero byte in the name"));
}

}  // namespace
}  // namespace racebeam
