// A picture of a waveform as a test reads it, by libxml2: nothing of tb/ is used.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

struct _xmlNode;  // of libxml2

namespace racebeam {

/// Throws std::runtime_error if the text is no XML, or a lane has no name.
class Svg {
 public:
  struct Text {
    double x, y;
    std::string text;
  };
  struct Shape {
    std::vector<double> xs;  ///< of the path's points, in order
    std::string value;       ///< in it, or in its title
    bool in_title;
    double text_x;
  };
  struct Lane {
    std::string path, name, role;
    double y = 0;
    std::vector<Shape> buses;
    std::vector<double> level_xs;  ///< where the line of a bit bends
    std::vector<double> unknown;   ///< left ends of hatched rectangles
    std::vector<std::string> values() const;
  };

  explicit Svg(const std::string& text);

  const Lane& operator[](const std::string& path) const;

  double width = 0, height = 0;
  std::vector<Lane> lanes;
  std::vector<Text> headings, places, clocks;
  std::vector<double> grid;             ///< x of the vertical lines
  std::map<std::string, int> elements;  ///< how many there are of each kind

 private:
  void read(_xmlNode* parent);
  void read_lane(_xmlNode* group, const std::string& role);
};

}  // namespace racebeam
