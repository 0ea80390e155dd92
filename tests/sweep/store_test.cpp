// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "tb/scene/engines.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/store_errors.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class StoreTest : public testing::Test {
 protected:
  QuickFolder folder;
  const std::string file = folder / "sweep.sqlite";
};

TEST_F(StoreTest, WhatWasStoredIsThereWhenItIsOpenedAgain) {
  const MeasuredFrame first = measured(7, 136'204), second = measured(3, -5, true);
  {
    OpenStore store(file);
    EXPECT_EQ(store.frames.put(store.key, {first, second}), 2);
    EXPECT_EQ(folder.files(), 3) << "the log and the memory that readers share";
  }
  EXPECT_EQ(folder.files(), 1) << "a closed store is one file";
  OpenStore store(file, Access::Read);
  EXPECT_THAT(store.frames.read(store.key), ElementsAre(second.row, first.row));
  EXPECT_THAT(store.frames.there(1, 1)[1], ElementsAre(KeptFrame{3, true}, KeptFrame{7, false}));
  EXPECT_EQ(store.frames.read(store.key, {"decisions"})[1].values,
            std::vector<std::int64_t>{136'204});
  EXPECT_EQ(store.models()[0].commit, "abc");
  EXPECT_EQ(store.scenes()[0].frames, 12799);
  EXPECT_EQ(store.points()[0].name, "chip");
}

TEST_F(StoreTest, MovedStoreGoesOn) {
  { OpenStore(file).frames.put({1, 1, 1}, {measured(1, 1)}); }
  QuickFolder other;
  std::filesystem::rename(file, other / "sweep.sqlite");
  OpenStore store(other / "sweep.sqlite");
  EXPECT_EQ(store.frames.put(store.key, {measured(1, 1), measured(2, 2)}), 1);
  EXPECT_EQ(store.frames.read(store.key).size(), 2u);
}

TEST_F(StoreTest, EqualFrameIsNotWrittenAgain) {
  OpenStore store(file);
  EXPECT_EQ(store.frames.put(store.key, {measured(1, 10), measured(2, 20)}), 2);
  EXPECT_EQ(store.frames.put(store.key, {measured(2, 20), measured(3, 30)}), 1);
  EXPECT_EQ(store.frames.read(store.key).size(), 3u);
}

TEST_F(StoreTest, FrameThatDoesNotRepeatIsAnErrorAndBothAreKept) {
  OpenStore store(file);
  store.frames.put(store.key, {measured(512, 136'204)});
  const auto again = [&store] {
    store.frames.put(store.key, {measured(511, 1), measured(512, 136'310)});
  };
  EXPECT_THROW(again(), NotDeterministic);
  EXPECT_EQ(error_of(again),
            "frame 512 of chip does not repeat: decisions was 136204, and is "
            "136310: this program counts differently");
  EXPECT_EQ(store.frames.read(store.key)[1].values[0], 136'204) << "the first one stays";
  EXPECT_EQ(store.frames.read(store.key)[0].frame, 511) << "the rest of the block is good";
  EXPECT_EQ(store.frames.disputed(store.key.model), 1);
  Statement both(store.database(), "SELECT figures FROM disputed ORDER BY figures");
  ASSERT_TRUE(both.next());
  EXPECT_THAT(both.text(0), HasSubstr("decisions=136204\n"));
  ASSERT_TRUE(both.next());
  EXPECT_THAT(both.text(0), HasSubstr("decisions=136310\n"));
}

TEST_F(StoreTest, FrameThatDiffersInItsPictureAloneDoesNotRepeat) {
  OpenStore store(file);
  MeasuredFrame frame = measured(1, 10);
  store.frames.put(store.key, {frame});
  frame.row.values[2] ^= 1;
  frame.row.digest = frame_digest(1, frame.row.values);
  EXPECT_THROW(store.frames.put(store.key, {frame}), NotDeterministic);
}

TEST_F(StoreTest, RowThatIsNotAsItsDigestSaysIsRefusedAndNothingOfItsBlockStored) {
  OpenStore store(file);
  MeasuredFrame garbled = measured(2, 20), short_one = measured(2, 20);
  garbled.row.values[1] ^= 4;
  short_one.row.values.pop_back();
  short_one.row.digest = frame_digest(2, short_one.row.values);
  for (const MeasuredFrame& bad : {garbled, short_one})
    EXPECT_THROW(store.frames.put(store.key, {measured(1, 10), bad}), std::invalid_argument);
  EXPECT_TRUE(store.frames.read(store.key).empty());
}

TEST_F(StoreTest, HistogramsAreSumsOverTheSampleEachFrameOnce) {
  OpenStore store(file);
  MeasuredFrame a = measured(1, 1), b = measured(2, 2), guard = measured(3, 3, true);
  a.histograms["slack"] = {1, 0, 5};
  b.histograms["slack"] = {1, 1, 1, 1};
  guard.histograms["slack"] = {100};
  store.frames.put(store.key, {a, guard});
  store.frames.put(store.key, {a, b});
  Histogram sum = store.frames.histograms(store.key)["slack"];
  EXPECT_EQ(sum.frames, 2);
  EXPECT_THAT(sum.bins, ElementsAre(2, 1, 6, 1));

  guard.row.guard = false;
  store.frames.put(store.key, {guard});
  guard.row.guard = true;
  store.frames.put(store.key, {guard});
  sum = store.frames.histograms(store.key)["slack"];
  EXPECT_EQ(sum.frames, 3) << "a guard frame has become one of the sample, and stays that";
  EXPECT_THAT(sum.bins, ElementsAre(102, 1, 6, 1));
  EXPECT_FALSE(store.frames.read(store.key)[2].guard);
}

TEST_F(StoreTest, CausesMayComeLaterButNotOthers) {
  OpenStore store(file);
  MeasuredFrame frame = measured(1, 1);
  store.frames.put(store.key, {frame});
  EXPECT_TRUE(store.frames.causes(store.key).empty());
  frame.causes = {{"give_up", 12}, {"starved", 0}};
  store.frames.put(store.key, {frame});
  store.frames.put(store.key, {frame});
  EXPECT_EQ(store.frames.causes(store.key)[1], frame.causes);
  store.frames.put(store.key, {measured(2, 2)});
  EXPECT_EQ(store.frames.with_causes(store.key.model, store.key.scene),
            (std::unordered_map<std::int64_t, std::vector<int>>{{store.key.point, {1}}}));
  EXPECT_EQ(store.frames.read_causes(store.key, {"other", "give_up"}),
            (std::vector<FrameRow>{{1, false, 0, {0, 12}}}));
  frame.causes["starved"] = 1;
  EXPECT_THROW(store.frames.put(store.key, {frame}), NotDeterministic);
}

TEST_F(StoreTest, KeysAreFoundByWhatTheyDependOn) {
  OpenStore store(file);
  const auto ids = store.points({{"dr_bits=9\n", "p1"}, {"dr_bits=8\n", "p2"}});
  EXPECT_EQ(store.points({{"dr_bits=8\n", "p1"}, {"dr_bits=9\n", "nine"}}),
            (std::vector<std::int64_t>{ids[1], ids[0]}));
  const std::vector<StoredPoint> points = store.points();
  EXPECT_EQ(points[1].name, "nine");
  EXPECT_EQ(points[2].name, "p1") << "a name is one point's";
  EXPECT_EQ(store.scene({"renamed", "d3", 12799}), store.key.scene);
  EXPECT_NE(store.scene({"demo", "other", 12799}), store.key.scene);
  EXPECT_THAT(error_of([&store] {
                store.model({"3f9c", "", "", "", ""}, {"decisions"});
              }),
              HasSubstr("the same model, 3f9c, with other figures"));
}

TEST_F(StoreTest, AnotherModelMayHaveOtherColumnsBesideTheOldRows) {
  OpenStore store(file);
  store.frames.put(store.key, {measured(1, 10)});
  const std::int64_t other = store.model({"other", "", "", "", ""}, {"merges", "decisions"});
  MeasuredFrame frame;
  frame.row = {1, false, frame_digest(1, {3, 11}), {3, 11}};
  store.frames.put({other, store.key.scene, store.key.point}, {frame});
  EXPECT_THAT(store.frames.read({other, 1, 1}), ElementsAre(frame.row));
  EXPECT_THAT(store.frames.read(store.key), ElementsAre(measured(1, 10).row));
}

TEST_F(StoreTest, ColumnsThatSqlWouldTakeForOthersAreRefused) {
  OpenStore store(file);
  for (const char* name : {"", "frame", "Digest", "a\nb"})
    EXPECT_THROW(store.model({"other", "", "", "", ""}, {"x", name}), std::invalid_argument)
        << name;
  EXPECT_THROW(store.model({"other", "", "", "", ""}, {"x", "X"}), std::invalid_argument);
  EXPECT_EQ(store.models().size(), 1u);
}

TEST(ModelHash, EveryEngineHasOne) {
  for (const engine* each : engines()) {
    EXPECT_THAT(model_hash(each->name), testing::MatchesRegex("[0-9a-f]*"));
    EXPECT_EQ(model_hash(each->name).size(), 32u);
  }
  EXPECT_THROW(model_hash("none"), std::invalid_argument);
}

TEST_F(StoreTest, CachesGiveBackWhatTheyGot) {
  OpenStore store(file);
  const std::string picture(307'200, '\x15');
  EXPECT_FALSE(store.references.find("r"));
  store.references.put("r", picture);
  store.references.put("r", picture);
  EXPECT_EQ(store.references.find("r"), picture);
  EXPECT_FALSE(store.units.find("u"));
  store.units.put({"u", "stacks", "Depth=4", "osu018", 86, 217, 1234.5});
  store.units.put({"v", "stacks", "Depth=4", "generic", 86, 217, {}});
  EXPECT_EQ(store.units.find("u")->area, 1234.5);
  EXPECT_EQ(store.units.find("v")->cells, 217);
  EXPECT_FALSE(store.units.find("v")->area);
}

TEST_F(StoreTest, NotesOfPointsAndRuns) {
  OpenStore store(file);
  store.failures.put(store.key, "died: Aborted");
  store.failures.put(store.key, "died: Killed");
  ASSERT_EQ(store.failures.all(store.key.model).size(), 1u);
  EXPECT_EQ(store.failures.all(store.key.model)[0].reason, "died: Killed");
  EXPECT_EQ(store.failures.all(store.key.model)[0].tries, 2);
  store.failures.remove(store.key);
  EXPECT_TRUE(store.failures.all(store.key.model).empty());
  const auto ids = store.points({{"a=1\n", "p1"}});
  store.stopped.replace(store.key.model, {{ids[0], 16, store.key.point, "dominated by chip"}});
  EXPECT_EQ(store.stopped.all(store.key.model)[0].why, "dominated by chip");
  const std::int64_t run = store.runs.begin({"box", "cpu", 2, "racebeam sweep run", "yosys 0.23"});
  EXPECT_EQ(store.runs.all()[0].ended, "");
  store.runs.end(run, 1.5);
  EXPECT_EQ(store.runs.all()[0].cpu_seconds, 1.5);
  EXPECT_THAT(store.runs.all()[0].ended, testing::MatchesRegex("20..-..-..T..:..:..Z"));
}

TEST_F(StoreTest, ViewHasTheMeansOfTheSampleAndFailedPointsToo) {
  OpenStore store(file);
  store.frames.put(store.key, {measured(1, 10), measured(2, 25), measured(3, 1000, true)});
  const auto ids = store.points({{"dr_bits=10\nfifo_entries=10\n", "chip"}, {"a=1\n", "p1"}});
  store.failures.put({store.key.model, store.key.scene, ids[1]}, "hangs");
  Statement view(store.database(),
                 "SELECT point, scene, frames, decisions, failure FROM points ORDER BY point");
  ASSERT_TRUE(view.next());
  EXPECT_EQ(view.text(0) + view.text(1), "chipdemo");
  EXPECT_EQ(view.integer(2), 2);
  EXPECT_EQ(view.real(3), 17.5);
  ASSERT_TRUE(view.next());
  EXPECT_EQ(view.text(0) + view.text(4), "p1hangs");
  EXPECT_EQ(view.kind(3), Statement::Null) << "a failed point has no figures";
}

TEST_F(StoreTest, ReaderSeesWhatIsCommittedWhileAnotherWrites) {
  OpenStore writer(file);
  writer.frames.put(writer.key, {measured(1, 1)});
  OpenStore reader(file, Access::Read);
  Transaction half(writer.database());
  writer.database().run("DELETE FROM frame");
  EXPECT_EQ(reader.frames.read(reader.key).size(), 1u);
}

TEST_F(StoreTest, FileSystemsOfSeveralMachinesGetARollbackJournal) {
  for (const std::uint64_t type : {0x6969u, 0xff534d42u, 0x0bd00bd0u, 0x47504653u})
    EXPECT_EQ(journal_on(type), Journal::Rollback) << std::hex << type;
  for (const std::uint64_t type : {0xef53u, 0x9123683eu, 0x58465342u, 0x01021994u})
    EXPECT_EQ(journal_on(type), Journal::Log) << std::hex << type;
  OpenStore store(file, Access::Write, Journal::Rollback);
  store.frames.put(store.key, {measured(1, 1)});
  EXPECT_EQ(folder.files(), 1);
}

}  // namespace
}  // namespace racebeam
