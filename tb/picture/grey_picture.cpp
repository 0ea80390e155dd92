// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/grey_picture.h"

#include <filesystem>
#include <system_error>

#include "tb/picture/image_library.h"

namespace racebeam {

std::string read_grey_picture(const std::string& path, GreyPicture& to) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return "there is no such file";
  // A device or a pipe may have no end.
  if (!std::filesystem::is_regular_file(status)) return "this is no file";
  return image_library().read_grey(path, to);
}

}  // namespace racebeam
