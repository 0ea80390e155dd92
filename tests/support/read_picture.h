// Pictures that the program wrote, read back by OpenImageIO.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

using Picture = std::vector<std::uint8_t>;

/// 6-bit colours of a picture in a file; 255 for what is none of the 64. Empty if there is none.
Picture read_picture(const std::string& path, int index, int& width, int& height);
Picture read_picture(const std::string& path, int index = 0);

}  // namespace racebeam
