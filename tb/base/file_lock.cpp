// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace racebeam {

FileLock::FileLock(const std::string& path)
    : file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0 && errno == EISDIR) file_ = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  error_ = file_ < 0 ? errno : 0;
}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

bool FileLock::take() {
  return file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

std::string FileLock::text() const {
  char bytes[256];
  const ssize_t size = pread(file_, bytes, sizeof bytes, 0);
  return size > 0 ? std::string(bytes, static_cast<std::size_t>(size)) : "";
}

void FileLock::write(const std::string& text) {
  if (ftruncate(file_, 0) != 0) return;
  [[maybe_unused]] const ssize_t written = pwrite(file_, text.data(), text.size(), 0);
}

}  // namespace racebeam
