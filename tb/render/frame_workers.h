// FrameWorkers: frames rendered by several processes, handed over in order.
//
// Each process renders ranges of a few frames, every one of which can start anywhere. What is ready
// waits in this process until it is its turn.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/render/rendered_frame.h"

namespace racebeam {

class FrameWorkers {
 public:
  using Render = std::function<RenderedFrame(int index)>;

  /// Forks `jobs` processes for the frames 0..frames - 1; `prepare` is called once in each. Nothing
  /// of SystemC may exist yet.
  FrameWorkers(int jobs, int frames, const std::function<Render()>& prepare);
  /// Ends them, without waiting for what nobody asked for.
  ~FrameWorkers();
  FrameWorkers(const FrameWorkers&) = delete;
  FrameWorkers& operator=(const FrameWorkers&) = delete;

  /// The next frame. Throws SyncError, RtlError and MissingTool as thrown in a process,
  /// std::runtime_error for any other error there, and, or MissingTool, if a process died. Nothing,
  /// perhaps, once interrupted().
  std::optional<RenderedFrame> next();

 private:
  struct Worker {
    pid_t process;
    int pipe;
    std::string received;
    bool whole() const;  // at least one record
    bool closed = false;
  };

  Worker& worker_of(int index) { return workers_[index / Range % workers_.size()]; }
  void work(std::size_t number, int pipe, const std::function<Render()>& prepare) const;
  void receive();

  static constexpr int Range = 8;  // frames in a row

  const int frames_;
  std::vector<Worker> workers_;
  int next_ = 0;
};

}  // namespace racebeam
