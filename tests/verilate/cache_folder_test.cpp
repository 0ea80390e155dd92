// The cache has a bound: what was not used for longest goes, and what is small stays longer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/cache_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tb/base/output_file.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t Half = 600'000'000;  // more than half of what is allowed; sparse files

TEST(CacheFolderTest, WhatWasNotUsedForLongestGoesAndASmallFileStays) {
  const fs::path folder = fs::path(testing::TempDir()) / "racebeam_cache_folder_test";
  fs::remove_all(folder);
  setenv("RACEBEAM_CACHE", folder.c_str(), 1);
  const auto big = [](const std::string& out) {
    write_text(out, "big");
    fs::resize_file(out, Half);
  };
  cached("proof", [](const std::string& out) { write_text(out, "equal\n"); });
  cached("first", big);
  const auto earlier = fs::file_time_type::clock::now() - std::chrono::hours(2);
  fs::last_write_time(folder / "proof", earlier);
  fs::last_write_time(folder / "first", earlier);
  cached("second", big);
  EXPECT_EQ(in_cache("first"), "");
  EXPECT_NE(in_cache("second"), "");
  EXPECT_NE(in_cache("proof"), "") << "a proof takes no place";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace racebeam
