// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/svg.h"

#include <libxml/parser.h>

#include <cstdlib>
#include <stdexcept>

namespace racebeam {

namespace {

std::string attribute(xmlNode* node, const char* name) {
  xmlChar* value = xmlGetProp(node, reinterpret_cast<const xmlChar*>(name));
  const std::string text = value ? reinterpret_cast<const char*>(value) : "";
  xmlFree(value);
  return text;
}

std::string content(xmlNode* node) {
  xmlChar* value = xmlNodeGetContent(node);
  const std::string text = reinterpret_cast<const char*>(value);
  xmlFree(value);
  return text;
}

double number(xmlNode* node, const char* name) { return std::atof(attribute(node, name).c_str()); }

// The points of M, L, H and V with absolute coordinates.
std::vector<double> xs_of(const std::string& d) {
  std::vector<double> xs;
  const char* at = d.c_str();
  const auto length = [&] {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) throw std::runtime_error("a path of " + d);
    at = end;
    return value;
  };
  while (const char command = *at) {
    ++at;
    if (command == 'Z') continue;
    const double first = length();
    if (command == 'M' || command == 'L') length();
    if (command != 'V') xs.push_back(first);
  }
  return xs;
}

}  // namespace

std::vector<std::string> Svg::Lane::values() const {
  std::vector<std::string> all;
  for (const Shape& bus : buses) all.push_back(bus.value);
  return all;
}

Svg::Svg(const std::string& text) {
  const int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  const auto size = static_cast<int>(text.size());
  xmlDoc* document = xmlReadMemory(text.data(), size, "picture", nullptr, options);
  if (!document) throw std::runtime_error("no XML: " + text.substr(0, 200));
  xmlNode* root = xmlDocGetRootElement(document);
  width = std::atof(attribute(root, "width").c_str());
  height = std::atof(attribute(root, "height").c_str());
  read(root);
  xmlFreeDoc(document);
}

const Svg::Lane& Svg::operator[](const std::string& path) const {
  for (const Lane& lane : lanes)
    if (lane.path == path) return lane;
  throw std::runtime_error("no lane " + path);
}

void Svg::read(xmlNode* parent) {
  for (xmlNode* node = parent->children; node; node = node->next) {
    if (node->type != XML_ELEMENT_NODE) continue;
    const std::string kind = reinterpret_cast<const char*>(node->name);
    const std::string classes = " " + attribute(node, "class") + " ";
    ++elements[kind];
    const auto is = [&](const char* one) {
      return classes.find(" " + std::string(one) + " ") != std::string::npos;
    };
    const Text text{number(node, "x"), number(node, "y"), kind == "text" ? content(node) : ""};
    if (is("heading")) headings.push_back(text);
    if (is("place")) places.push_back(text);
    if (is("clock")) clocks.push_back(text);
    if (is("grid")) grid.push_back(xs_of(attribute(node, "d")).at(0));
    if (is("lane")) read_lane(node, attribute(node, "class").substr(5));
    else read(node);
  }
}

void Svg::read_lane(xmlNode* group, const std::string& role) {
  Lane lane{attribute(group, "data-signal"), "", role, 0, {}, {}, {}};
  const std::string moved = attribute(group, "transform");  // translate(0 Y)
  lane.y = std::atof(moved.c_str() + moved.find(' '));
  for (xmlNode* node = group->children; node; node = node->next) {
    if (node->type != XML_ELEMENT_NODE) continue;
    const std::string one = attribute(node, "class"), d = attribute(node, "d");
    if (one == "name") lane.name = content(node);
    if (one == "level") lane.level_xs = xs_of(d);
    if (one == "unknown") lane.unknown.push_back(number(node, "x"));
    if (one == "bus") lane.buses.push_back({xs_of(d), content(node), node->children != nullptr, 0});
    if (one == "value") {
      lane.buses.back().value = content(node);
      lane.buses.back().text_x = number(node, "x");
    }
  }
  if (lane.name.empty()) throw std::runtime_error("a lane without a name");
  lanes.push_back(lane);
}

}  // namespace racebeam
