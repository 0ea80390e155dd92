// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/room_reader.h"

#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

constexpr int FarthestCentre = 1000000;
constexpr int LargestHalf = 8191;
constexpr int NamesHelped = 50;  // looking for the nearest of thousands of names takes time

std::string place_text(Place place) { return "line " + std::to_string(place.line); }

void read_portals(const TomlNode& node, int room, std::vector<NamedPortal>& portals,
                  Faults& faults) {
  const TableReader table(node, "portals", faults);
  for (int face = 0; face < FaceCount; ++face) {
    const TomlNode* value = table.find(face_name(face));
    if (!value) continue;
    const bool several = value->kind == TomlNode::Array;
    if (several && value->items.size() > PortalsPerFace) {
      faults.add(value->place, std::string("'") + face_name(face) + "' has more than four portals",
                 "a face holds up to four; split the room");
      continue;
    }
    const std::size_t count = several ? value->items.size() : 1;
    for (std::size_t i = 0; i < count; ++i) {
      const TomlNode& name = several ? value->items[i] : *value;
      std::string id;
      if (read_text(name, face_name(face), id, faults))
        portals.push_back({room, face, id, name.place});
    }
  }
}

void read_room(const TomlNode& node, std::vector<Room>& rooms, std::vector<NamedPortal>& portals,
               std::vector<std::string>& faulty, Faults& faults) {
  const TableReader table(node, "room", faults);
  if (node.kind != TomlNode::Table) return;
  Room room;
  room.place = node.place;
  table.require("id", "give it a name: id = \"hall\"");
  table.require("centre", "say where it is: centre = [0, 0, 0]");
  table.require("half_size", "say how large it is: half_size = [128, 256, 128]");
  table.read("set", room.set, true);
  const bool named = table.read("id", room.id);
  if (named) room.place = table.find("id")->place;
  const bool placed = table.read("centre", -FarthestCentre, FarthestCentre, room.centre);
  const bool sized = table.read("half_size", 1, LargestHalf, room.half_size);
  std::vector<NamedPortal> own;
  if (const TomlNode* value = table.find("portals"))
    read_portals(*value, static_cast<int>(rooms.size()), own, faults);
  if (named && (!placed || !sized)) faulty.push_back(room.id);
  if (!named || !placed || !sized) return;
  portals.insert(portals.end(), own.begin(), own.end());
  rooms.push_back(std::move(room));
}

}  // namespace

void read_rooms(const TomlNode& node, std::vector<Room>& rooms, std::vector<NamedPortal>& portals,
                std::vector<std::string>& faulty, Faults& faults) {
  if (node.kind != TomlNode::Array) {
    faults.add(node.place, std::string("'room' is ") + node.kind_name(),
               "write each room below a line [[room]]");
    return;
  }
  for (const TomlNode& item : node.items) read_room(item, rooms, portals, faulty, faults);
}

std::map<std::string, int> room_numbers(const std::vector<Room>& rooms,
                                        const std::vector<std::string>& faulty, Faults& faults) {
  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const auto [at, added] = numbers.emplace(rooms[i].id, static_cast<int>(i));
    if (added) continue;
    faults.add(rooms[i].place, "the room id " + quoted(rooms[i].id) + " is used twice",
               "rename one; the other is in " + place_text(rooms[at->second].place));
  }
  for (const std::string& id : faulty) numbers.emplace(id, FaultyRoom);
  return numbers;
}

std::string room_help(const std::string& id, const std::map<std::string, int>& numbers,
                      const Faults& faults) {
  if (faults.count() > NamesHelped)
    return "check the name; ids of plan cells are storey.row.column, after the set if any";
  std::vector<std::string> known;
  for (const auto& [name, number] : numbers) known.push_back(name);
  return name_help(id, known);
}

void connect_named(const std::vector<NamedPortal>& portals,
                   const std::map<std::string, int>& numbers, bool overlap,
                   std::vector<Room>& rooms, Faults& faults) {
  for (const NamedPortal& portal : portals) {
    const auto at = numbers.find(portal.id);
    const Room& from = rooms[portal.room];
    if (at == numbers.end()) {
      faults.add(portal.place, "there is no room " + quoted(portal.id),
                 room_help(portal.id, numbers, faults));
      continue;
    }
    if (at->second == FaultyRoom) continue;
    const Room& to = rooms[at->second];
    if (from.set != to.set) {
      faults.add(portal.place,
                 "rooms " + quoted(from.id) + " and " + quoted(to.id) + " are of different sets",
                 "portals stay within a set; a [[shot]] changes it");
    } else if (!overlap && !rooms_touch(from, portal.face, to)) {
      faults.add(portal.place,
                 "the " + std::string(face_name(portal.face)) + " face of " + quoted(from.id) +
                     " does not touch " + quoted(to.id),
                 "move one of them until their faces have an area in common");
    } else {
      connect(rooms, portal.room, portal.face, at->second);
    }
  }
}

}  // namespace racebeam
