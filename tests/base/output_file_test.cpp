// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/output_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tb/base/leftovers.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string error_of(const std::string& path, std::string_view text = "x") {
  try {
    write_text(path, text);
  } catch (const OutputError& error) {
    return error.what();
  }
  return "no error";
}

class OutputFileTest : public testing::Test {
 protected:
  ScratchFolder folder;
};

TEST_F(OutputFileTest, AppearsOnlyAtCommit) {
  const std::string path = folder / "a.txt";
  OutputFile file(path);
  file.write("hel", 3);
  file.write("lo", 2);
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit(5);
  EXPECT_EQ(read(path), "hello");
  EXPECT_EQ(folder.files(), 1);
}

TEST_F(OutputFileTest, TemporaryIsHiddenInTheSameFolderWithTheSameExtension) {
  const OutputFile file(folder / "a.b.png");
  const std::filesystem::path temporary(file.temporary_path());
  EXPECT_EQ(temporary.parent_path().string(), folder.path());
  EXPECT_EQ(temporary.extension(), ".png");
  EXPECT_EQ(temporary.filename().string().find(".a.b."), 0u);
  const OutputFile same(folder / "a.b.png");
  EXPECT_NE(file.temporary_path(), same.temporary_path());
}

TEST_F(OutputFileTest, WhatADeadProgramLeftGoesAndNothingElse) {
  const pid_t child = fork();
  if (child == 0) {
    OutputFile file(folder / "a.png");
    file.write("x", 1);
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  ASSERT_EQ(folder.files(), 1) << "it was killed in the middle";
  const std::string dead = "-" + std::to_string(child) + "-1.png";
  const std::vector<std::string> others = {".b" + dead, ".c.ffffffff" + dead,
                                           "d." + owner_mark() + "-1.png",
                                           ".e." + owner_mark() + "-1.png"};
  for (const std::string& name : others) std::ofstream(folder / name) << "of somebody else";
  write_text(folder / "f.txt", "text");
  EXPECT_EQ(folder.files(), 5) << "the child's is gone";
  for (const std::string& name : others)
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
}

TEST_F(OutputFileTest, WithoutCommitNothingIsLeftAndTheOldFileStays) {
  const std::string path = folder / "a.txt";
  write_text(path, "old");
  {
    OutputFile file(path);
    file.write("new", 3);
  }
  EXPECT_EQ(read(path), "old");
  EXPECT_EQ(folder.files(), 1);
}

TEST_F(OutputFileTest, CommitAcceptsAFileWrittenByOthers) {
  OutputFile file(folder / "a.txt");
  std::ofstream(file.temporary_path()) << "by others";
  file.commit();
  EXPECT_EQ(read(folder / "a.txt"), "by others");
}

TEST_F(OutputFileTest, AfterFinishOnlyTheNameIsMissing) {
  OutputFile file(folder / "a.txt");
  file.write("x", 1);
  EXPECT_THROW(file.finish(2), OutputError);
  file.finish(1);
  EXPECT_EQ(read(file.temporary_path()), "x");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  file.commit();
  EXPECT_EQ(read(folder / "a.txt"), "x");
}

TEST_F(OutputFileTest, ExtensionsAreLowerCase) {
  EXPECT_EQ(extension_of("a.b/c.d.VcD"), ".vcd");
  EXPECT_EQ(extension_of("a.b/c"), "");
}

// As `mv -f` does: the folder's owner decides, not the file's mode.
TEST_F(OutputFileTest, AWriteProtectedFileIsReplaced) {
  write_text(folder / "a.txt", "old");
  std::filesystem::permissions(folder / "a.txt", std::filesystem::perms::owner_read);
  write_text(folder / "a.txt", "new");
  EXPECT_EQ(read(folder / "a.txt"), "new");
}

TEST_F(OutputFileTest, CommitRefusesWhatIsMissingOrShort) {
  OutputFile missing(folder / "a.txt");
  EXPECT_THROW(missing.commit(), OutputError);
  OutputFile brief(folder / "b.txt");
  brief.write("x", 1);
  EXPECT_THROW(brief.commit(2), OutputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.txt"));
}

TEST_F(OutputFileTest, ErrorsNameThePathAndTheReason) {
  const std::string nowhere = folder / "no/a.txt";
  EXPECT_EQ(error_of(nowhere), "cannot write " + nowhere + ": No such file or directory");
  write_text(folder / "plain", "x");
  const std::string below_file = folder / "plain/a.txt";
  EXPECT_EQ(error_of(below_file), "cannot write " + below_file + ": Not a directory");
  EXPECT_EQ(error_of(folder.path()), "cannot write " + folder.path() + ": Is a directory");
  EXPECT_EQ(error_of(""), "cannot write \"\": No such file or directory");
}

TEST_F(OutputFileTest, FullDiskIsNoticedAndLeavesNothing) {
  EXPECT_EQ(error_of("/dev/full"), "cannot write /dev/full: No space left on device");
  const std::string path = folder / "a.txt";
  const FileSizeLimit limit(1000);
  EXPECT_EQ(error_of(path, std::string(1001, 'x')), "cannot write " + path + ": File too large");
  EXPECT_EQ(error_of(path, std::string(100000, 'x')), "cannot write " + path + ": File too large");
  EXPECT_EQ(folder.files(), 0);
  EXPECT_EQ(error_of(path, std::string(1000, 'x')), "no error");
}

TEST_F(OutputFileTest, LinksAreFollowedAndDevicesStayDevices) {
  write_text(folder / "real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  write_text(folder / "link.txt", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(read(folder / "real.txt"), "new");
  write_text("/dev/null", "gone");
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
}

TEST_F(OutputFileTest, EmptyTextIsAFile) {
  write_text(folder / "a.txt", "");
  EXPECT_TRUE(std::filesystem::exists(folder / "a.txt"));
}

}  // namespace
}  // namespace racebeam
