// Clocks of port traffic as few bytes: of each port what changed, and then deflated.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace racebeam {

/// `values` by clock, then by port, of `ports` ports.
std::string pack_traffic(const std::vector<std::uint64_t>& values, std::size_t ports);

/// The values of so many clocks; false if the bytes are not those of so many.
bool unpack_traffic(std::string_view bytes, std::size_t ports, std::size_t clocks,
                    std::vector<std::uint64_t>& values);

}  // namespace racebeam
