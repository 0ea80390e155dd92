// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/block_runner.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "tb/base/child.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int Pause = 100;               // milliseconds
constexpr int Tries = 2;                 // of the same frame
constexpr int TriesIfKilled = 100;       // by somebody else, who says nothing of the point
constexpr std::size_t LastWords = 4096;  // bytes

}  // namespace

struct BlockRunner::Job {
  Block block;
  ForkServer::Worker worker;
  std::vector<Answer> answers{};
  std::string text{};   ///< of a line that has not ended
  std::string words{};  ///< lines that are no answers
  std::string error{};
  bool done = false, hangs = false;
  Clock::time_point heard = Clock::now();

  bool answered(int frame) const {
    return std::any_of(answers.begin(), answers.end(),
                       [&](const Answer& one) { return one.frame.row.frame == frame; });
  }
};

BlockRunner::BlockRunner(ForkServer& server, int jobs, Owner& owner, Seconds patience)
    : server_(server), jobs_(jobs), owner_(owner), patience_(patience) {}

BlockRunner::~BlockRunner() {
  for (Job& job : running_) {
    kill(job.worker.process, SIGKILL);
    close(job.worker.file);
  }
}

bool BlockRunner::run(std::list<Block> blocks) {
  waiting_ = std::move(blocks);
  while (!running_.empty() || !waiting_.empty()) {
    if (interrupted()) {
      time_to_finish();
      if (running_.empty()) return false;
    } else if (static_cast<int>(running_.size()) < jobs_ && !waiting_.empty()) {
      Block next = std::move(waiting_.front());
      waiting_.pop_front();
      start(std::move(next));
      continue;
    }
    listen();
    owner_.look();
  }
  return !interrupted();
}

void BlockRunner::start(Block block) {
  owner_.prepare(block);
  const ForkServer::Worker worker = server_.start(request_text(block));
  block.kept.clear();
  running_.push_back({std::move(block), worker});
}

void BlockRunner::listen() {
  std::vector<pollfd> waits;
  for (const Job& job : running_) waits.push_back({job.worker.file, POLLIN, 0});
  poll(waits.data(), waits.size(), Pause);
  auto wait = waits.begin();
  for (auto job = running_.begin(); job != running_.end(); ++wait) {
    bool alive = true;
    if (wait->revents) {
      alive = read_lines(*job);
    } else if (!job->hangs && Clock::now() - job->heard > patience()) {
      job->hangs = true;
      kill(job->worker.process, SIGKILL);
    }
    if (alive) {
      ++job;
      continue;
    }
    Job ended = std::move(*job);
    job = running_.erase(job);
    end(ended);
  }
}

BlockRunner::Seconds BlockRunner::patience() const { return std::max(patience_, 20 * slowest_); }

bool BlockRunner::read_lines(Job& job) {
  char buffer[65536];
  const ssize_t got = read(job.worker.file, buffer, sizeof buffer);
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return true;
  if (got <= 0) return false;
  job.text.append(buffer, static_cast<std::size_t>(got));
  std::size_t begin = 0;
  for (std::size_t end; (end = job.text.find('\n', begin)) != std::string::npos; begin = end + 1)
    take_line(job, job.text.substr(begin, end - begin));
  job.text.erase(0, begin);
  return true;
}

void BlockRunner::take_line(Job& job, const std::string& line) {
  AnswerLine read = read_answer(line, job.block.number);
  const auto now = Clock::now();
  switch (read.kind) {
    case AnswerLine::Frame: {
      const std::vector<int>& frames = job.block.frames;
      const int frame = read.answer.frame.row.frame;
      if (std::find(frames.begin(), frames.end(), frame) == frames.end() || job.answered(frame))
        break;
      if (!job.answers.empty()) slowest_ = std::max<Seconds>(slowest_, now - job.heard);
      job.answers.push_back(std::move(read.answer));
      break;
    }
    case AnswerLine::Done: job.done = true; break;
    case AnswerLine::Error: job.error = read.error; break;
    case AnswerLine::Garbage:
      job.words += line + "\n";
      if (job.words.size() > LastWords) job.words.erase(0, job.words.size() - LastWords);
  }
  job.heard = now;
}

void BlockRunner::end(Job& job) {
  close(job.worker.file);
  const int status = server_.wait(job.worker);
  if (!job.text.empty()) job.words += job.text + "\n";
  if (!job.answers.empty()) owner_.take(job.block, job.answers);
  std::vector<int>& frames = job.block.frames;
  frames.erase(
      std::remove_if(frames.begin(), frames.end(), [&](int frame) { return job.answered(frame); }),
      frames.end());
  if (frames.empty()) return;
  const bool killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL && !job.hangs;
  job.block.tries = job.answers.empty() ? job.block.tries + 1 : 1;
  std::string reason;
  if (!job.error.empty()) reason = job.error;
  else if (job.hangs)
    reason = fmt::format("a worker said nothing for {:.0f} s", patience().count());
  else if (status != 0) reason = death_of("a worker", status);
  else reason = "a worker answered with garbage";
  if (job.block.tries >= (killed ? TriesIfKilled : Tries))
    owner_.fail(job.block, fmt::format("frame {}: {}", frames.front(), reason), job.words);
  else waiting_.push_front(std::move(job.block));
}

}  // namespace racebeam
