// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/fork_server.h"

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "tb/base/child.h"

namespace racebeam {

namespace {

// An end of a pipe of two ways crosses the control socket with one byte.
union FileMessage {
  char bytes[CMSG_SPACE(sizeof(int))];
  cmsghdr align;
};

bool send_file(int control, int file) {
  char byte = 0;
  iovec data{&byte, 1};
  FileMessage file_message{};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = file_message.bytes;
  message.msg_controllen = sizeof file_message.bytes;
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(header), &file, sizeof file);
  return sendmsg(control, &message, MSG_NOSIGNAL) == 1;
}

// -1: there is no more.
int receive_file(int control) {
  char byte = 0;
  iovec data{&byte, 1};
  FileMessage file_message{};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = file_message.bytes;
  message.msg_controllen = sizeof file_message.bytes;
  ssize_t got;
  while ((got = recvmsg(control, &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
  }
  if (got != 1) return -1;
  const cmsghdr* header = CMSG_FIRSTHDR(&message);
  if (!header || header->cmsg_type != SCM_RIGHTS) return -1;
  int file;
  std::memcpy(&file, CMSG_DATA(header), sizeof file);
  return file;
}

// The request of a worker: all until the other end is shut for writing.
std::string read_request(int file) {
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t got = read(file, buffer, sizeof buffer);
    if (got > 0) text.append(buffer, static_cast<std::size_t>(got));
    else if (got == 0 || errno != EINTR) return text;
  }
}

sigset_t children() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGCHLD);
  return set;
}

}  // namespace

bool send_all(int socket, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t sent = send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) return false;
    if (sent > 0) done += static_cast<std::size_t>(sent);
  }
  return true;
}

ForkServer::ForkServer(Work work) : work_(std::move(work)) { open(); }

ForkServer::~ForkServer() { shut(); }

void ForkServer::open() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::runtime_error(std::string("no pipe to workers: ") + strerror(errno));
  server_ = fork_child();
  if (server_ == 0) {
    close(ends[0]);
    serve(ends[1]);
  }
  close(ends[1]);
  control_ = ends[0];
  if (server_ < 0) {
    server_ = 0;
    shut();
    throw std::runtime_error(std::string("no process for workers: ") + strerror(errno));
  }
}

void ForkServer::shut() {
  if (server_ > 0) {
    kill(server_, SIGKILL);
    wait_for_child(server_);
  }
  if (control_ >= 0) close(control_);
  server_ = 0;
  control_ = -1;
  ended_.clear();
}

void ForkServer::serve(int control) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) signal(number, SIG_IGN);
  const sigset_t set = children();
  sigprocmask(SIG_BLOCK, &set, nullptr);
  const int ends = signalfd(-1, &set, SFD_CLOEXEC);
  pollfd waits[] = {{control, POLLIN, 0}, {ends, POLLIN, 0}};
  for (;;) {
    if (poll(waits, 2, -1) < 0) continue;
    if (waits[1].revents) {
      signalfd_siginfo info;
      (void)!read(ends, &info, sizeof info);
      int status = 0;
      for (pid_t child; (child = waitpid(-1, &status, WNOHANG)) > 0;) {
        const Message message{0, child, status};
        (void)!send(control, &message, sizeof message, MSG_NOSIGNAL);
      }
    }
    if (!waits[0].revents) continue;
    const int file = receive_file(control);
    if (file < 0) _exit(0);  // nobody asks any more
    const pid_t child = fork_child();
    if (child == 0) {
      close(control);
      close(ends);
      sigprocmask(SIG_UNBLOCK, &set, nullptr);
      work_(read_request(file), file);
      _exit(0);
    }
    close(file);
    const Message message{child, 0, errno};
    (void)!send(control, &message, sizeof message, MSG_NOSIGNAL);
  }
}

bool ForkServer::next(Message& message) {
  ssize_t got;
  while ((got = recv(control_, &message, sizeof message, 0)) < 0 && errno == EINTR) {
  }
  return got == sizeof message;
}

ForkServer::Worker ForkServer::start(const std::string& request) {
  constexpr int Tries = 4;
  for (int tries = 0; tries < Tries; ++tries) {
    if (server_ == 0) open();  // before the pipe: or the server would keep it open
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error(std::string("no pipe to a worker: ") + strerror(errno));
    Message message{};
    bool good = send_file(control_, ends[1]);
    while (good && (good = next(message)) && message.ended) ended_[message.ended] = message.status;
    close(ends[1]);
    if (good && message.started > 0) {
      send_all(ends[0], request);  // a worker that is gone already is seen at its end
      shutdown(ends[0], SHUT_WR);
      return {message.started, ends[0], server_};
    }
    close(ends[0]);
    if (good)
      throw std::runtime_error(std::string("no process for a worker: ") + strerror(message.status));
    shut();  // somebody has killed it, and so its workers
  }
  throw std::runtime_error("the process that starts workers dies again and again");
}

int ForkServer::wait(const Worker& worker) {
  for (Message message; worker.server == server_ && !ended_.count(worker.process);) {
    if (!next(message)) shut();
    else ended_[message.ended] = message.status;
  }
  if (worker.server != server_) return SIGKILL;  // they die with their server
  const int status = ended_[worker.process];
  ended_.erase(worker.process);
  return status;
}

}  // namespace racebeam
