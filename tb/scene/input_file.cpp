// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/input_file.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "tb/base/whole_file.h"

namespace racebeam {

std::optional<std::string> read_input_file(const std::string& path, const std::string& kind,
                                           Faults& faults) {
  constexpr std::uintmax_t LargestFile = 16 << 20;
  const std::filesystem::path file(path);
  const auto refuse = [&](const std::string& why, const std::string& help) {
    faults.add({}, why, help);
    return std::nullopt;
  };
  const auto too_large = [&] {
    return refuse("the file is larger than 16 MB", "is it a " + kind + "?");
  };
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    return refuse("this is a folder", "name a " + kind + " file in it");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > LargestFile) return too_large();
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return refuse(std::string("cannot be read: ") + std::strerror(errno),
                  "check the name; `racebeam " + kind + " new` writes a file to start from");
  // Devices have no size: no more than a file may have is taken.
  std::string text = next_bytes(in, LargestFile + 1);
  if (in.bad()) return refuse("cannot be read", "is the disk in order?");
  if (text.size() > LargestFile) return too_large();
  return text;
}

}  // namespace racebeam
