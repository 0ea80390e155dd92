// SmallDisk: a disk in memory, seen by this process alone.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

namespace racebeam {

/// What is mounted goes with the object. A user who is not root becomes that in a name space of
/// users, where the machine lets him; this lasts as long as the process.
class SmallDisk {
 public:
  explicit SmallDisk(const std::string& folder, const char* size = "1m") : folder_(folder) {
    if (!own_mounts() || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        !mount_with(size, 0))
      why_ = std::string("no disk can be mounted here: ") + std::strerror(errno);
  }
  ~SmallDisk() {
    if (why_.empty()) umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  /// Why there is none; "": there is.
  const std::string& why_not() const { return why_; }
  bool grow(const char* size) { return mount_with(size, MS_REMOUNT); }
  bool make_read_only() { return mount_with("1m", MS_REMOUNT | MS_RDONLY); }

 private:
  static bool own_mounts() {
    if (unshare(CLONE_NEWNS) == 0) return true;
    const uid_t user = geteuid();
    const gid_t group = getegid();
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    return true;
  }
  bool mount_with(const char* size, unsigned long flags) {
    const std::string options = std::string("mode=700,size=") + size;
    return mount("none", folder_.c_str(), "tmpfs", flags, options.c_str()) == 0;
  }

  const std::string folder_;
  std::string why_;
};

}  // namespace racebeam
