// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/frame_workers.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "sc/swap/rtl_library.h"
#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

/// A record is its kind, its size and so many bytes.
enum Kind : char { Frame, Sync, Rtl, Missing, Other };
struct Header {
  Kind kind;
  std::uint64_t size;
};

constexpr std::size_t Ahead = std::size_t{64} << 20;  // bytes that wait for their turn, per process

std::string record(Kind kind, const std::string& bytes) {
  const Header header{kind, bytes.size()};
  return std::string(reinterpret_cast<const char*>(&header), sizeof header) + bytes;
}

Header header_of(const std::string& received) {
  Header header{};
  std::memcpy(&header, received.data(), sizeof header);
  return header;
}

}  // namespace

bool FrameWorkers::Worker::whole() const {
  return received.size() >= sizeof(Header) &&
         received.size() >= sizeof(Header) + header_of(received).size;
}

FrameWorkers::FrameWorkers(int jobs, int frames, const std::function<Render()>& prepare)
    : frames_(frames) {
  workers_.resize(static_cast<std::size_t>(jobs));
  for (std::size_t number = 0; number < workers_.size(); ++number) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a child process");
    const pid_t child = fork_child();
    if (child < 0) throw std::runtime_error("no child process");
    if (child == 0) {
      for (std::size_t other = 0; other < number; ++other) close(workers_[other].pipe);
      close(ends[0]);
      work(number, ends[1], prepare);
      _exit(0);
    }
    close(ends[1]);
    workers_[number] = {child, ends[0], {}};
  }
}

FrameWorkers::~FrameWorkers() {
  for (const Worker& worker : workers_) {
    close(worker.pipe);
    if (worker.process == 0) continue;
    kill(worker.process, SIGKILL);  // it writes no files
    wait_for_child(worker.process);
  }
}

// In the child: its ranges, until they are done, something fails, or nobody listens.
void FrameWorkers::work(std::size_t number, int pipe,
                        const std::function<Render()>& prepare) const {
  std::string last;
  try {
    const Render render = prepare();
    for (int index = 0; index < frames_ && !interrupted(); ++index) {
      if (index / Range % workers_.size() != number) continue;
      if (!write_all(pipe, record(Frame, render(index).bytes()))) return;
    }
    return;
  } catch (const Interrupted&) {
    return;
  } catch (const SyncError& error) {
    last = record(Sync, error.what());
  } catch (const RtlError& error) {
    last = record(Rtl, error.what());
  } catch (const MissingTool& error) {
    last = record(Missing, error.what());
  } catch (const std::exception& error) {
    last = record(Other, error.what());
  }
  write_all(pipe, last);
}

// Waits for anything, from anyone who is not too far ahead.
void FrameWorkers::receive() {
  std::vector<pollfd> pipes;
  std::vector<Worker*> readers;
  for (Worker& worker : workers_) {
    if (worker.closed || worker.received.size() > Ahead) continue;
    pipes.push_back({worker.pipe, POLLIN, 0});
    readers.push_back(&worker);
  }
  constexpr int Pause = 100;  // milliseconds: a signal may come just before
  if (poll(pipes.data(), pipes.size(), Pause) <= 0) return;
  static std::vector<char> buffer(1 << 20);
  for (std::size_t i = 0; i < pipes.size(); ++i) {
    if (!pipes[i].revents) continue;
    const ssize_t got = read(pipes[i].fd, buffer.data(), buffer.size());
    if (got > 0) readers[i]->received.append(buffer.data(), static_cast<std::size_t>(got));
    else if (got == 0 || errno != EINTR) readers[i]->closed = true;
  }
}

std::optional<RenderedFrame> FrameWorkers::next() {
  Worker& worker = worker_of(next_++);
  while (!worker.whole()) {
    if (interrupted()) return {};
    if (worker.closed)
      throw_death("a process that rendered frames",
                  wait_for_child(std::exchange(worker.process, 0)));
    receive();
  }
  const Header header = header_of(worker.received);
  const std::string bytes = worker.received.substr(sizeof header, header.size);
  worker.received.erase(0, sizeof header + header.size);
  switch (header.kind) {
    case Frame: return RenderedFrame::of_bytes(bytes);
    case Sync: throw SyncError(bytes);
    case Rtl: throw RtlError(bytes);
    case Missing: throw MissingTool(bytes);
    default: throw std::runtime_error(bytes);
  }
}

}  // namespace racebeam
