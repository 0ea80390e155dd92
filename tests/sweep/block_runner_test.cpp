// Workers that crash, hang, talk garbage or are killed: what they have answered is kept, others get
// the rest, and only their own point fails.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/block_runner.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <map>

#include "sc/beam/knobs.h"
#include "tb/sweep/row_digest.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Answer answer_of(int block, int frame) {
  Answer answer;
  answer.block = block;
  answer.frame.row = {frame, false, 0, {frame * 7}};
  answer.frame.row.digest = frame_digest(frame, answer.frame.row.values);
  return answer;
}

/// Whether this is the first call with this name, of all processes.
bool first_time(const std::string& folder, const std::string& name) {
  return mkdir((folder + "/" + name).c_str(), 0700) == 0;
}

/// Points 1.. whose workers do what they are told at frame 3, always or the first time.
struct Behaviour {
  std::function<void(int file)> at_3{};
  bool always = false;
};

class BlockRunnerTest : public testing::Test, public BlockRunner::Owner {
 protected:
  void prepare(Block&) override {}
  void take(const Block& block, const std::vector<Answer>& answers) override {
    for (const Answer& answer : answers) {
      EXPECT_EQ(answer.frame.row.values, std::vector<std::int64_t>{answer.frame.row.frame * 7});
      EXPECT_TRUE(taken[block.point].insert(answer.frame.row.frame).second) << "twice";
    }
  }
  void fail(const Block& block, const std::string& reason, const std::string& words) override {
    failed[block.point] = reason + "|" + words;
  }
  void look() override {}

  /// Runs a block of frames 1..5 for each point.
  void run(std::map<int, Behaviour> points, int jobs = 2) {
    ForkServer server([this, points](const std::string& request, int file) {
      const Block block = block_of(request);
      for (const int frame : block.frames) {
        const Behaviour& behaviour = points.at(block.point);
        if (frame == 3 && behaviour.at_3 &&
            (behaviour.always || first_time(folder.path(), std::to_string(block.point))))
          behaviour.at_3(file);
        send_all(file, answer_line(answer_of(block.number, frame)));
      }
      send_all(file, done_line(block.number));
    });
    std::list<Block> blocks;
    for (const auto& [point, behaviour] : points) {
      Block block;
      block.number = block.point = point;
      block.frames = {1, 2, 3, 4, 5};
      blocks.push_back(block);
    }
    EXPECT_TRUE(
        BlockRunner(server, jobs, *this, std::chrono::milliseconds(300)).run(std::move(blocks)));
  }

  ScratchFolder folder;
  std::map<int, std::set<int>> taken;
  std::map<int, std::string> failed;
};

const auto All = testing::ElementsAre(1, 2, 3, 4, 5);
const auto Before = testing::ElementsAre(1, 2);

TEST_F(BlockRunnerTest, AllBlocksAreDoneWithAnyNumberOfWorkers) {
  for (const int jobs : {1, 3, 40}) {
    taken.clear();
    std::map<int, Behaviour> points;
    for (int point = 1; point <= 20; ++point) points[point] = {};
    run(points, jobs);
    EXPECT_EQ(taken.size(), 20u);
    for (const auto& [point, frames] : taken) EXPECT_THAT(frames, All) << point;
  }
  EXPECT_TRUE(failed.empty());
}

TEST_F(BlockRunnerTest, ACrashOnceCostsNothing) {
  run({{1, {[](int) { abort(); }}}, {2, {[](int) { _exit(5); }}}, {3, {}}});
  EXPECT_TRUE(failed.empty());
  for (const int point : {1, 2, 3}) EXPECT_THAT(taken[point], All) << point;
}

TEST_F(BlockRunnerTest, ACrashAtTheSameFrameFailsThePointAlone) {
  run({{1, {[](int file) { send_all(file, "terminate called\n"), abort(); }, true}}, {2, {}}});
  EXPECT_THAT(failed[1], HasSubstr("frame 3: a worker died: Aborted"));
  EXPECT_THAT(failed[1], HasSubstr("|terminate called")) << "its last words";
  EXPECT_THAT(taken[1], Before);
  EXPECT_THAT(taken[2], All);
  EXPECT_EQ(failed.size(), 1u);
}

TEST_F(BlockRunnerTest, AWorkerThatHangsIsKilled) {
  run({{1, {[](int) { pause(); }, true}}, {2, {[](int) { pause(); }}}, {3, {}}});
  EXPECT_THAT(failed[1], HasSubstr("frame 3: a worker said nothing for 0 s"));
  EXPECT_THAT(taken[1], Before);
  EXPECT_THAT(taken[2], All);
  EXPECT_THAT(taken[3], All);
}

TEST_F(BlockRunnerTest, GarbageIsNoAnswer) {
  const auto garbage = [](int file) {
    std::string line = answer_line(answer_of(1, 3));
    line.replace(line.find("21"), 2, "22");  // not as its digest says
    send_all(file, line + "{\n" + answer_line(answer_of(77, 3)) + answer_line(answer_of(1, 99)));
    _exit(0);
  };
  run({{1, {garbage, true}}, {2, {}}});
  EXPECT_THAT(failed[1], HasSubstr("frame 3: a worker answered with garbage"));
  EXPECT_THAT(taken[1], Before);
  EXPECT_THAT(taken[2], All);
}

TEST_F(BlockRunnerTest, AnErrorIsTheReason) {
  run({{1, {[](int file) { send_all(file, error_line(1, "no such \"room\"")), _exit(0); }, true}}});
  EXPECT_THAT(failed[1], HasSubstr("frame 3: no such \"room\""));
}

// Killed from outside says nothing of the point: it is tried more often.
TEST_F(BlockRunnerTest, WorkersThatSomebodyKillsAreReplaced) {
  for (int point = 1; point <= 3; ++point) {
    const auto kill_some = [this, point](int) {
      for (int n = 0; n < 5; ++n)
        if (first_time(folder.path(), std::to_string(point) + "_" + std::to_string(n)))
          kill(getpid(), SIGKILL);
    };
    run({{point, {kill_some, true}}});
    EXPECT_THAT(taken[point], All);
  }
  EXPECT_TRUE(failed.empty());
}

TEST_F(BlockRunnerTest, AServerThatSomebodyKillsIsReplaced) {
  const auto kill_server = [](int) { kill(getppid(), SIGKILL), pause(); };
  run({{1, {kill_server}}, {2, {kill_server}}, {3, {}}, {4, {}}});
  EXPECT_TRUE(failed.empty());
  for (const int point : {1, 2, 3, 4}) EXPECT_THAT(taken[point], All) << point;
}

// Or a worker that dies while its request is written would end the whole sweep.
TEST(ForkServer, SaysThatAReaderIsGoneWithoutASignal) {
  int ends[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  EXPECT_TRUE(send_all(ends[0], "read by nobody"));
  close(ends[1]);
  ASSERT_EQ(signal(SIGPIPE, SIG_DFL), SIG_DFL);
  EXPECT_FALSE(send_all(ends[0], "read by nobody"));
  close(ends[0]);
}

TEST(Block, RequestsAndAnswersCrossAPipe) {
  Block block;
  block.number = 17;
  block.scene_name = "house";
  knobs k;
  k.hurry_threshold = -1;
  block.k = k;
  block.frames = {5, 700};
  k.fifo_entries = 5;
  block.base = k;
  block.kept[700] = {std::string("\0\xff\n", 3), "end", {"", std::string("\0", 1)}};
  block.reference = SweepReference::Trace4;
  const Block same = block_of(request_text(block));
  EXPECT_EQ(same.number, 17);
  EXPECT_EQ(same.scene_name, "house");
  EXPECT_TRUE(same.k == block.k);
  EXPECT_THAT(same.frames, ElementsAre(5, 700));
  EXPECT_TRUE(same.base == block.base);
  ASSERT_EQ(same.kept.count(700), 1);
  const KeptPictures& kept = same.kept.at(700);
  EXPECT_EQ(kept.reference, block.kept[700].reference);
  EXPECT_EQ(kept.end, "end");
  EXPECT_EQ(kept.links, block.kept[700].links);
  EXPECT_EQ(same.reference, SweepReference::Trace4);

  Answer answer = answer_of(17, 5);
  answer.made = {std::string("\0\x80\xff", 3), "", {"", "link"}};
  answer.frame.histograms["slack"] = {1, 2, 3};
  answer.frame.causes["starved"] = 12;
  const AnswerLine read = read_answer(answer_line(answer), 17);
  ASSERT_EQ(read.kind, AnswerLine::Frame);
  EXPECT_EQ(read.answer.made.reference, answer.made.reference);
  EXPECT_EQ(read.answer.made.end, "");
  EXPECT_EQ(read.answer.made.links, answer.made.links);
  EXPECT_EQ(read.answer.frame.histograms, answer.frame.histograms);
  EXPECT_EQ(read.answer.frame.causes, answer.frame.causes);
  EXPECT_EQ(read_answer(answer_line(answer), 18).kind, AnswerLine::Garbage) << "another block's";
  EXPECT_EQ(read_answer(done_line(17), 17).kind, AnswerLine::Done);
}

}  // namespace
}  // namespace racebeam
