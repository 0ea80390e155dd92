// What happens to a store's file: other programs, newer ones, damage, single bits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "tb/base/whole_file.h"
#include "tb/sweep/store_check.h"
#include "tb/sweep/store_errors.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

class StoreFiles : public testing::Test {
 protected:
  /// Some of everything that has a digest; values of eight bytes, which stand in the file as such.
  void fill() {
    OpenStore store(file);
    std::vector<MeasuredFrame> block;
    for (int frame = 1; frame <= 40; ++frame) {
      block.push_back(measured(frame, Big + frame));
      block.back().histograms["slack"] = {frame, 2, 3};
      block.back().causes["starved"] = Big + 1000 + frame;
    }
    store.frames.put(store.key, block);
    store.units.put({"u", "stacks", "Depth=4", "generic", Big + 2000, 217, 5.5});
    store.references.put("r", std::string(5000, 'x') + "y");
  }
  /// All that check_store() answers for, as text.
  std::string results() const {
    OpenStore store(file, Access::Read);
    std::string text;
    for (const auto& [point, frames] : store.frames.there(1, 1))
      text += std::to_string(point) + ":" + std::to_string(frames.size()) + "\n";
    for (const FrameRow& row : store.frames.read(store.key)) {
      text += std::to_string(row.frame) + (row.guard ? "g" : "s");
      for (const std::int64_t value : row.values) text += " " + std::to_string(value);
    }
    for (const auto& [name, histogram] : store.frames.histograms(store.key))
      for (const std::int64_t bin : histogram.bins) text += " " + std::to_string(bin);
    for (const auto& [frame, causes] : store.frames.causes(store.key))
      for (const auto& [cause, pixels] : causes)
        text += "\n" + std::to_string(frame) + cause + std::to_string(pixels);
    if (const auto unit = store.units.find("u"))
      text += std::to_string(unit->flip_flops) + " " + std::to_string(unit->cells);
    return text + store.references.find("r").value_or("none");
  }
  std::string refusal(Access access) const {
    return error_of([this, access] { OpenStore store(file, access); });
  }

  static constexpr std::int64_t Big = 0x0123456789ab0000;
  QuickFolder folder;
  const std::string file = folder / "sweep.sqlite";
};

TEST_F(StoreFiles, SoundStoreHasNoFaults) {
  fill();
  const StoreReport report = check_store(file);
  EXPECT_THAT(report.faults, IsEmpty());
  EXPECT_EQ(report.rows.at("frame"), 40);
  EXPECT_EQ(report.rows.at("cause"), 40);
}

TEST_F(StoreFiles, OneBitOfAnyStoredCounterIsFound) {
  fill();
  const std::string sound = whole_file(file);
  const auto flip = [&](std::int64_t value) {
    std::string bytes;
    for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
    const std::size_t at = sound.find(bytes);
    EXPECT_NE(at, std::string::npos);
    EXPECT_EQ(sound.find(bytes, at + 1), std::string::npos);
    std::string damaged = sound;
    const auto bits = static_cast<std::uint64_t>(value);
    damaged[at + bits % 8] ^= static_cast<char>(1 << bits % 7);
    write(file, damaged);
    return check_store(file).faults;
  };
  for (int frame = 1; frame <= 40; ++frame) {
    const std::string text = "frame " + std::to_string(frame) + " of chip in demo does not have";
    EXPECT_THAT(flip(Big + frame), ElementsAre(HasSubstr(text)));
    EXPECT_THAT(flip(measured(frame, Big + frame).row.values[2]), ElementsAre(HasSubstr(text)));
    EXPECT_THAT(flip(Big + 1000 + frame), ElementsAre(HasSubstr("the row of cause with")));
  }
  EXPECT_THAT(flip(Big + 2000), ElementsAre(HasSubstr("the row of unit with")));
}

TEST_F(StoreFiles, NoBitOfTheFileChangesAResultUnnoticed) {
  fill();
  const std::string sound = whole_file(file), before = results();
  std::mt19937 random(14);
  for (int round = 0; round < 300; ++round) {
    std::string damaged = sound;
    const std::size_t at = random() % damaged.size();
    const int bit = static_cast<int>(random() % 8);
    damaged[at] ^= static_cast<char>(1 << bit);
    write(file, damaged);
    bool noticed = false;
    try {
      noticed = !check_store(file).faults.empty();
    } catch (const UsageError&) {
      noticed = true;
    }
    EXPECT_TRUE(noticed || results() == before) << "byte " << at << " bit " << bit;
  }
}

TEST_F(StoreFiles, NewerSchemaIsNamedAndLeftAlone) {
  fill();
  Database(file, Access::Write).run("UPDATE meta SET value = '2' WHERE key = 'version'");
  const std::string bytes = whole_file(file);
  for (const Access access : {Access::Read, Access::Write})
    EXPECT_THAT(refusal(access), AllOf(HasSubstr(file + " is of a newer racebeam: version 2"),
                                       HasSubstr("this one knows 1")));
  EXPECT_THROW(check_store(file), UsageError);
  EXPECT_EQ(whole_file(file), bytes);
}

TEST_F(StoreFiles, FileOfSomethingElseIsNamedAndLeftAlone) {
  Database(file, Access::Write).run("CREATE TABLE meta(a, b); INSERT INTO meta VALUES (1, 2)");
  const std::string bytes = whole_file(file);
  for (const Access access : {Access::Read, Access::Write})
    EXPECT_THAT(refusal(access), HasSubstr(file + " is not the store of a sweep"));
  EXPECT_EQ(whole_file(file), bytes);
  write(file, std::string(10'000, 'a'));
  for (const Access access : {Access::Read, Access::Write})
    EXPECT_THAT(refusal(access), AllOf(HasSubstr(file + " is damaged: file is not a database"),
                                       HasSubstr("racebeam sweep check " + folder.path())));
  EXPECT_EQ(whole_file(file), std::string(10'000, 'a'));
}

TEST_F(StoreFiles, ShortenedFileIsNamedAndLeftAloneAndCheckSaysSo) {
  fill();
  const std::string bytes = whole_file(file), half = bytes.substr(0, bytes.size() / 2);
  write(file, half);
  EXPECT_THAT(refusal(Access::Write), HasSubstr("is damaged: database disk image is malformed"));
  EXPECT_EQ(whole_file(file), half);
  EXPECT_THAT(check_store(file).faults, Not(IsEmpty()));
}

TEST_F(StoreFiles, CheckTellsWhatCanBeReadBesideADamagedTable) {
  fill();
  std::int64_t page = 0;
  {
    Database database(file, Access::Read);
    Statement root(database, "SELECT rootpage FROM sqlite_schema WHERE name = 'cause'");
    ASSERT_TRUE(root.next());
    page = root.integer(0);
  }
  std::string bytes = whole_file(file);
  bytes.replace(static_cast<std::size_t>(page - 1) * 4096, 4096, std::string(4096, '\xa5'));
  write(file, bytes);
  const StoreReport report = check_store(file);
  EXPECT_THAT(report.faults, testing::Contains(HasSubstr("table cause cannot be read to its end")));
  EXPECT_EQ(report.rows.at("frame"), 40);
  OpenStore store(file);
  EXPECT_THROW(store.frames.causes(store.key), DamagedStore);
  EXPECT_EQ(store.frames.read(store.key).size(), 40u);
}

TEST_F(StoreFiles, MissingOrEmptyFileIsNoStore) {
  EXPECT_THAT(refusal(Access::Read), HasSubstr("cannot read " + file));
  write(file, "");
  EXPECT_THAT(refusal(Access::Read), HasSubstr("no sweep has begun there"));
  EXPECT_EQ(refusal(Access::Write), "no error") << "a run that was killed at once leaves that";
}

}  // namespace
}  // namespace racebeam
