// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/sphere_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sc/sphere/engine.h"
#include "tb/base/counted.h"
#include "tb/scene/tables_reader.h"

namespace racebeam {

namespace {

constexpr int MaxPictures = 16383;
constexpr int MaxRadius = 63, MaxSpheres = SphereEntries - 1, FullReflect = 4095;
constexpr int Switches = 18, Keys = 4;
constexpr int NarrowOff = 1 << 5, ReflectionsAt = 2;

const std::vector<std::string> AntialiasWords = {"none", "4x", "8x"};  // of SW1, SW0

std::vector<std::string> input_names() {
  std::vector<std::string> names;
  for (int n = 0; n < Switches; ++n) names.push_back("SW" + std::to_string(n));
  for (int n = 0; n < Keys; ++n) names.push_back("KEY" + std::to_string(n));
  return names;
}

int fixed(double number) { return static_cast<int>(std::lround(number * 4096)); }

/// Reads all; the tables of one kind at a time.
class Reader : TablesReader {
 public:
  Reader(const SceneText& file, SphereProgram& program, Faults& faults)
      : TablesReader(file.root, sphere_scene_keys(), faults), program_(program) {}

  void read() {
    one("eye", [this](const TableReader& eye) { read_eye(eye); });
    one("light", [this](const TableReader& light) { read_light(light); });
    one("modes", [this](const TableReader& modes) { read_modes(modes); });
    one("box", [this](const TableReader& box) { read_box(box, program_.box); });
    all("sphere", MaxSpheres, "the table holds the light as well",
        [this](const TableReader& sphere) { read_sphere(sphere); });
    all("plane", PlaneEntries, "the table holds no more",
        [this](const TableReader& plane) { read_plane(plane); });
    all("input", MaxPictures, "", [this](const TableReader& input) { read_input(input); });
    program_.set_start(planes_);
    program_.spheres = static_cast<int>(program_.moving.size());
    expect_spheres(!program_.moving.empty(), "sphere");
    check();
  }

 private:
  void colour(const TableReader& from, sphere_colour& to) const {
    std::uint32_t rgb = 0xffffff;
    from.read_rgb("colour", rgb);
    for (int n = 0; n < 3; ++n) to[static_cast<std::size_t>(n)] = rgb >> (16 - 8 * n + 3) & 31;
  }
  int reflect(const TableReader& from) const {
    double part = 0;
    from.read("reflect", 0.0, 1.0, part);
    return std::min(fixed(part), FullReflect);
  }

  void read_eye(const TableReader& eye) {
    Vector3 position{0, 0, -32};
    place(eye, "position", position);
    program_.start.origin = table_position(position);
    double screen = 8;
    eye.read("screen", -FarAway / 32, FarAway / 32, screen);
    program_.start.screen = fixed(screen);
    eye_at_ = place_of(eye, "position");
  }
  void read_light(const TableReader& from) {
    place(from, "position", light_);
    program_.start.light = table_position(light_);
    light_at_ = place_of(from, "position");
  }
  void read_modes(const TableReader& modes) {
    int size = 0, reflections = 0, antialias = 0;
    modes.read_choice("size", {"512x480", "320x240"}, size);
    modes.read("reflections", 0, 3, reflections);
    modes.read_choice("antialias", AntialiasWords, antialias);
    modes.read("planes", planes_);
    program_.modes = (size == 0 ? NarrowOff : 0) | reflections << ReflectionsAt | antialias;
  }
  void read_sphere(const TableReader& from) {
    MovingSphere sphere;
    check_id(from);
    from.require("centre", "write centre = [x, y, z]");
    from.require("radius", "write radius = 5; it is whole, 1..63");
    place(from, "centre", sphere.centre);
    from.read("radius", 1, MaxRadius, sphere.radius);
    colour(from, sphere.colour);
    sphere.reflect = reflect(from);
    from.read("velocity", -Fastest, Fastest, sphere.velocity);
    program_.moving.push_back(sphere);
    sphere_at_.push_back(place_of(from, "centre"));
  }
  void read_plane(const TableReader& from) {
    plane_row plane;
    from.require("normal", "write normal = [x, y, z], of length 1");
    from.require("distance", "write distance = 22");
    Vector3 normal{};
    if (place(from, "normal", normal) && std::abs(length(normal) - 1) > 1.0 / 64) {
      const double is = length(normal);
      faults_.add(from.find("normal")->place,
                  fmt::format("'normal' is of length {:.4g}, not of 1", is),
                  is > 0 ? fmt::format("write [{:.4f}, {:.4f}, {:.4f}]", normal[0] / is,
                                       normal[1] / is, normal[2] / is)
                         : "write a direction: [0, -1, 0] is up");
    }
    plane.normal = table_position(normal);
    double distance = 0;
    from.read("distance", -FarAway, FarAway, distance);
    plane.distance = fixed(distance);
    colour(from, plane.colour);
    plane.reflect = reflect(from);
    from.read("checker", 0, 15, plane.checker);
    plane.limited = from.read("limits", 1, static_cast<int>(FarAway), plane.limit);
    program_.planes.push_back(plane);
  }

  void read_input(const TableReader& from) {
    static const std::vector<std::string> names = input_names();
    SphereInput input;
    from.read("picture", 0, MaxPictures - 1, input.picture);
    from.read("pictures", 1, MaxPictures, input.pictures);
    const TomlNode* hold = from.require("hold", "write hold = [\"SW15\", \"KEY0\"]");
    if (hold && hold->kind != TomlNode::Array)
      return wrong_type(*hold, "hold", "a list of names: [\"SW15\", \"KEY0\"]", faults_);
    for (const TomlNode& each : hold ? hold->items : std::vector<TomlNode>()) {
      std::string name;
      if (!read_text(each, "hold", name, faults_)) continue;
      const auto at = std::find(names.begin(), names.end(), name);
      const int n = static_cast<int>(at - names.begin());
      if (at == names.end())
        faults_.add(each.place, "there is no switch or key " + quoted(name),
                    "there is SW0..SW17 and KEY0..KEY3");
      else (n < Switches ? input.sw : input.keys) |= 1 << (n < Switches ? n : n - Switches);
    }
    program_.inputs.push_back(input);
  }

  // What only all tables together tell.
  void check() {
    if (program_.start.screen == program_.start.origin[2] >> 5)
      faults_.add(eye_at_,
                  fmt::format("the eye is on the screen, which stands at z = {}",
                              program_.start.screen / 128.0),
                  "move it away: z is smaller in front of the screen");
    for (std::size_t n = 0; n < program_.moving.size(); ++n) {
      const MovingSphere& sphere = program_.moving[n];
      Vector3 from = sphere.centre;
      for (std::size_t k = 0; k < 3; ++k) from[k] -= light_[k];
      if (length(from) < sphere.radius)
        faults_.add(light_at_.line ? light_at_ : sphere_at_[n],
                    fmt::format("the light is inside the sphere in line {}", sphere_at_[n].line),
                    "move the light or the sphere: shadows are found from outside");
      check_inside(sphere_at_[n], sphere.centre, program_.box);
    }
  }

  SphereProgram& program_;
  bool planes_ = true;
  Vector3 light_{15, 15, -1};
  Place eye_at_{1, 1}, light_at_{};
  std::vector<Place> sphere_at_;
};

}  // namespace

const racebeam::engine& SphereScene::engine() const { return sphere_engine(); }

std::string SphereScene::part(int picture) const {
  const sphere_inputs_core now = program_.inputs_before(picture);
  std::string modes;
  const auto add = [&](const std::string& mode) { modes += (modes.empty() ? "" : ", ") + mode; };
  if (now.alias_q) add(AntialiasWords[now.alias_q]);
  if (now.max_reflections_q) add(counted(now.max_reflections_q, "reflection"));
  if (now.planes_q && !program_.planes.empty()) add("planes");
  return modes.empty() ? "plain" : modes;
}

std::string SphereScene::counts() const {
  return counted(program_.moving.size(), "sphere") + ", " +
         counted(program_.planes.size(), "plane");
}

std::vector<SceneFact> SphereScene::facts() const {
  const bool moves =
      std::any_of(program_.moving.begin(), program_.moving.end(),
                  [](const MovingSphere& sphere) { return length(sphere.velocity) > 0; });
  const int sw = program_.board.sw;
  return {{"spheres", program_.spheres},
          {"planes", static_cast<int>(program_.planes.size())},
          {"planes_on", !(program_.board.key_n & 1 << 2)},
          {"pictures", pictures_},
          {"size", std::string(sw & NarrowOff ? "512x480" : "320x240")},
          {"reflections", sw >> ReflectionsAt & 3},
          {"antialias", AntialiasWords[sw & 3]},
          {"moves", moves},
          {"inputs", static_cast<int>(program_.inputs.size())}};
}

std::shared_ptr<const AnyScene> read_sphere_scene(const SceneText& file, Faults& faults) {
  const auto scene = std::make_shared<SphereScene>();
  scene->name_ = file.name;
  const TableReader top(file.root, "", faults, sphere_scene_keys());
  top.read("name", scene->name_);
  top.read("frames", 1, MaxPictures, scene->pictures_);
  Reader(file, scene->program_, faults).read();
  if (!faults.none()) return nullptr;
  return scene;
}

}  // namespace racebeam
