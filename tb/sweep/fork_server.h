// ForkServer: a small process that forks workers, since a process that has simulated, or is large,
// is a bad one to fork.
//
// Start it before anything else is opened. It dies with the process that made it, and its workers
// with it. A server that was killed is started anew when the next worker is asked for.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <functional>
#include <map>
#include <string>

namespace racebeam {

/// What a worker does with a request. Its lines go to the file; then it ends. Not interrupted by
/// Ctrl-C: whoever asked decides.
using Work = std::function<void(const std::string& request, int file)>;

/// Writes all bytes to a socket; false, without SIGPIPE, if its reader is gone.
bool send_all(int socket, const std::string& bytes);

class ForkServer {
 public:
  /// Throws std::runtime_error if there is no process, or no pipe to it.
  explicit ForkServer(Work work);
  /// Kills it and all workers.
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  struct Worker {
    pid_t process = 0;
    int file = -1;     ///< to read its lines from, until its end; the caller closes it
    pid_t server = 0;  ///< that has forked it
  };
  /// A worker with a request. Throws std::runtime_error.
  Worker start(const std::string& request);

  /// Waits for the end of a worker; its status as of waitpid(), or that of a killed one if the
  /// server is gone.
  int wait(const Worker& worker);

 private:
  void open();
  void shut();
  /// The next message of the server: a worker that ended, or 0 and the one that it has started.
  /// False if the server is gone.
  struct Message {
    pid_t started, ended;
    int status;
  };
  bool next(Message& message);
  [[noreturn]] void serve(int control);

  const Work work_;
  pid_t server_ = 0;
  int control_ = -1;
  std::map<pid_t, int> ended_;  // statuses that nobody has asked for yet
};

}  // namespace racebeam
