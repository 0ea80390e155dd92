// RTL that is saved while Verilator reads it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/rtl_syntax.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A Verilator in PATH that saves mine.sv and its include while it runs.
class RtlSavedTest : public testing::Test {
 protected:
  RtlSavedTest() : path_(std::getenv("PATH")) {
    fs::create_directories(folder / "inc");
    save("2");
  }
  ~RtlSavedTest() override { setenv("PATH", path_.c_str(), 1); }

  /// The width of the port is in an include that lies elsewhere.
  void save(const std::string& bits) const {
    std::ofstream(folder / "mine.sv") << "// " << bits << "\n`include \"inc/bits.svh\"\n"
                                      << "module stacks (input [`BITS-1:0] a);\nendmodule\n";
    std::ofstream(folder / "inc/bits.svh") << "`define BITS " << bits << "\n";
  }
  /// `before` and `after` are what the shell does around each run with the option `with`.
  void meanwhile(const std::string& with, const std::string& before, const std::string& after) {
    fs::create_directory(folder / "bin");
    const std::string tool = folder / "bin/verilator";
    std::ofstream(tool) << "#!/bin/sh\nwhole=\"$*\"\ndo_it() { case $whole in *" << with
                        << "*) (cd '" << folder.path() << "' && eval \"$1\") ;; esac; }\ndo_it '"
                        << before << "'\nPATH='" << path_ << "' verilator \"$@\"\ncode=$?\ndo_it '"
                        << after << "'\nexit $code\n";
    fs::permissions(tool, fs::perms::owner_all);
    setenv("PATH", ((folder / "bin:") + path_).c_str(), 1);
  }
  RtlSources sources() const { return {"stacks", {folder / "mine.sv"}}; }
  int bits_of_xml() const { return read_rtl_syntax(sources()).ports.at(0).bits; }
  int bits_of_plugin() const {
    const rtl_library library(rtl_plugin(sources()));
    return rtl_port_of(library.model(), "a").bits;
  }

  // Once: the new file is there.
  const std::string SaveOnce =
      "[ -e old ] || { cp -r inc old; echo \"\\`define BITS 7\" > "
      "inc/bits.svh; }";
  ScratchFolder folder;

 private:
  const std::string path_;
};

TEST_F(RtlSavedTest, SyntaxIsKeptUnderWhatWasRead) {
  meanwhile("--xml-only", "", SaveOnce);
  EXPECT_EQ(bits_of_xml(), 7);
  save("2");
  EXPECT_EQ(bits_of_xml(), 2);
  save("7");
  EXPECT_EQ(bits_of_xml(), 7);
}

TEST_F(RtlSavedTest, PluginIsKeptUnderWhatWasRead) {
  EXPECT_EQ(bits_of_xml(), 2);
  meanwhile("--cc", SaveOnce, "");
  EXPECT_EQ(bits_of_plugin(), 7);
  std::ofstream(folder / "inc/bits.svh") << "`define BITS 2\n";
  EXPECT_EQ(bits_of_plugin(), 2);
}

TEST_F(RtlSavedTest, FilesThatChangeAllTheTimeAreTold) {
  meanwhile("--xml-only", "", "echo \"// more\" >> mine.sv");
  try {
    read_rtl_syntax(sources());
    FAIL();
  } catch (const RtlError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the files of stacks change while Verilator reads them"));
  }
}

}  // namespace
}  // namespace racebeam
