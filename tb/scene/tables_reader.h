// TablesReader: what readers of scenes of spheres share: tables by kind, names, the box, colours.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/host/ball_motion.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

class TablesReader {
 protected:
  static constexpr double FarAway = 1000, Fastest = 64;

  TablesReader(const TomlNode& root, const std::vector<FileKey>& keys, Faults& faults)
      : root_(root), faults_(faults), keys_(keys) {}

  TableReader table(const TomlNode& node, const std::string& kind) const {
    return TableReader(node, kind, faults_, keys_);
  }
  /// Calls read(table) if there is such a table.
  template <class Read>
  void one(const char* kind, Read&& read) {
    if (const TomlNode* node = root_.find(kind)) read(table(*node, kind));
  }
  /// The same for each of an array of tables; more than `most` are a fault.
  template <class Read>
  void all(const std::string& kind, int most, const std::string& why, Read&& read) {
    for (const TomlNode& each : items(kind, most, why)) read(table(each, kind));
  }

  bool place(const TableReader& from, const char* key, Vector3& to) const {
    return from.read(key, -FarAway, FarAway, to);
  }
  /// Where a key is; where its table is, if it has none.
  static Place place_of(const TableReader& from, const char* key) {
    return from.find(key) ? from.find(key)->place : from.place();
  }
  /// The key `id`, if there is one: unlike all others.
  void check_id(const TableReader& from);
  void read_box(const TableReader& box, MotionBox& walls) const;
  /// There must be one; `engine` for the help.
  void expect_spheres(bool some, const std::string& engine) const;
  /// A warning if a sphere starts outside of the box.
  void check_inside(const Place& at, const Vector3& centre, const MotionBox& box) const;

  const TomlNode& root_;
  Faults& faults_;

 private:
  const std::vector<TomlNode>& items(const std::string& kind, int most,
                                     const std::string& why) const;

  const std::vector<FileKey>& keys_;
  std::map<std::string, int> ids_;  // with their lines
};

inline double length(const Vector3& v) { return std::sqrt(dot(v, v)); }

}  // namespace racebeam
