// Promises of tb/verilate/source_list.h on files that are read and never verilated.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/source_list.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tb/base/errors.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SourceList : public testing::Test {
 protected:
  SourceList() {
    std::filesystem::create_directories(folder.path() + "/rtl");
    for (const char* file : {"/a.sv", "/rtl/b.sv", "/rtl/a_pkg.sv"})
      std::ofstream(folder.path() + file);
  }
  /// What a list with this text names, without the folder.
  std::vector<std::string> files(const std::string& text) {
    const std::string list = folder.path() + "/list.f";
    std::ofstream(list) << text;
    std::vector<std::string> names;
    for (const std::string& file : read_source_list("unit", list).files)
      names.push_back(std::filesystem::path(file).lexically_relative(folder.path()).string());
    return names;
  }
  std::string refusal(const std::string& text) {
    try {
      files(text);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }

  ScratchFolder folder;
};

TEST_F(SourceList, PackagesOfAFolderComeFirst) {
  EXPECT_THAT(files("a.sv // and\nrtl\n"), ElementsAre("a.sv", "rtl/a_pkg.sv", "rtl/b.sv"));
}

TEST_F(SourceList, AZeroByteInANameIsRefused) {
  EXPECT_THAT(refusal(std::string("a.sv\nrtl\0x\n", 11)),
              HasSubstr("list.f:2: a zero byte in the name of a file for the unit unit"));
}

TEST_F(SourceList, AListThatNamesItselfIsRefused) {
  EXPECT_THAT(refusal("a.sv\n-f list.f\n"), HasSubstr("list.f names itself"));
}

}  // namespace
}  // namespace racebeam
