// Rooms given in full, and the portals that their author names.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/scene/scene_file.h"
#include "tb/scene/toml_tree.h"

namespace racebeam {

/// A portal as written: the name is not looked up yet.
struct NamedPortal {
  int room;
  int face;
  std::string id;
  Place place;
};

/// The number of a room that has a fault: what names it is not one more.
constexpr int FaultyRoom = -1;

/// Adds the good rooms of all [[room]] tables and what they say of portals, and the ids of the
/// others.
void read_rooms(const TomlNode& node, std::vector<Room>& rooms, std::vector<NamedPortal>& portals,
                std::vector<std::string>& faulty, Faults& faults);

/// Room number of each id; doubled ids are faults.
std::map<std::string, int> room_numbers(const std::vector<Room>& rooms,
                                        const std::vector<std::string>& faulty, Faults& faults);

/// Looks names up, checks that the rooms touch (unless `overlap`), and connects them.
void connect_named(const std::vector<NamedPortal>& portals,
                   const std::map<std::string, int>& numbers, bool overlap,
                   std::vector<Room>& rooms, Faults& faults);

/// Help for the name of a room that does not exist.
std::string room_help(const std::string& id, const std::map<std::string, int>& numbers,
                      const Faults& faults);

}  // namespace racebeam
