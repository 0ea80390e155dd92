// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/block_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sc/block/codes.h"
#include "sc/block/engine.h"
#include "sc/block/numbers.h"
#include "tb/base/counted.h"
#include "tb/scene/tables_reader.h"

namespace racebeam {

namespace {

constexpr int MaxPictures = 16383;
// What the numbers of the renderer hold.
constexpr double MaxCoordinate = 256;   // 12.20 after block_convert
constexpr double MaxSquare = 1024;      // block_normalise: of a vector it makes a unit of
constexpr double MaxWay = 2048;         // squares on the way to a discriminant are signed 12.20
constexpr double MaxDiscriminant = 8;   // block_root: radius^2 is the largest
constexpr double MinRadius = 1.0 / 64;  // below it, nothing is left of the discriminant
constexpr double MinScale = 1.0 / 64;

double square(const Vector3& a) { return dot(a, a); }

bool moves(const std::vector<BlockBody>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const BlockBody& body) { return length(body.velocity) > 0; });
}

/// Reads all; the tables of one kind at a time.
class Reader : TablesReader {
 public:
  Reader(const SceneText& file, BlockProgram& program, Faults& faults)
      : TablesReader(file.root, block_scene_keys(), faults), program_(program) {}

  void read(const TableReader& top) {
    read_scale(top);
    one("screen", [this](const TableReader& screen) { read_screen(screen); });
    one("eye", [this](const TableReader& eye) {
      place(eye, "position", eye_);
      eye_at_ = place_of(eye, "position");
    });
    one("light", [this](const TableReader& light) {
      place(light, "position", light_);
      light_at_ = place_of(light, "position");
    });
    one("box", [this](const TableReader& box) { read_box(box, box_); });
    all("sphere", BlockEntries, "the cores hold no more",
        [this](const TableReader& sphere) { read_sphere(sphere); });
    expect_spheres(!bodies_.empty(), "block");
    if (!faults_.none()) return;
    for (std::size_t n = 0; n < bodies_.size(); ++n)
      check_inside(sphere_at_[n], bodies_[n].centre, box_);
    map();
    check();
  }

 private:
  void read_scale(const TableReader& top) {
    top.read("scale", MinScale, 1.0, scale_);
    int exponent = 0;
    if (std::frexp(scale_, &exponent) != 0.5)
      faults_.add(top.find("scale")->place, fmt::format("'scale' is {:g}, no power of two", scale_),
                  "write 1, 0.5, 0.25, 0.125, 0.0625, 0.03125 or 0.015625");
  }
  void read_screen(const TableReader& from) {
    from.read("z", -FarAway, FarAway, screen_z_);
    const TomlNode* size = from.find("size");
    screen_at_ = place_of(from, "size");
    if (!size) return;
    if (size->kind != TomlNode::Array || size->items.size() != 2)
      return wrong_type(*size, "size", "two numbers: [8, 6]", faults_);
    for (std::size_t n = 0; n < 2; ++n)
      read_decimal(size->items[n], "size", 1.0 / 64, 2 * FarAway, screen_[n], faults_);
  }
  void read_sphere(const TableReader& from) {
    BlockBody body;
    check_id(from);
    from.require("centre", "write centre = [x, y, z]");
    from.require("radius", "write radius = 0.75");
    place(from, "centre", body.centre);
    from.read("radius", 0.0, FarAway, body.radius);
    read_colour(from, body.colour);
    from.read("velocity", -Fastest, Fastest, body.velocity);
    bodies_.push_back(body);
    sphere_at_.push_back(place_of(from, "centre"));
    radius_at_.push_back(place_of(from, "radius"));
  }
  void read_colour(const TableReader& from, std::array<float, 3>& to) const {
    const TomlNode* node = from.find("colour");
    Vector3 parts{1, 1, 1};
    std::uint32_t rgb = 0xffffff;
    if (node && node->kind == TomlNode::Array) from.read("colour", 0.0, 1.0, parts);
    else if (from.read_rgb("colour", rgb))
      for (std::size_t n = 0; n < 3; ++n) parts[n] = (rgb >> (16 - 8 * n) & 255) / 255.0;
    for (std::size_t n = 0; n < 3; ++n) to[n] = static_cast<float>(parts[n]);
  }

  Vector3 mapped(const Vector3& p) const {
    return {scale_ * p[0], -scale_ * p[1], scale_ * (p[2] - screen_z_)};
  }
  static std::array<float, 3> floats(const Vector3& p) {
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  }
  // Into the renderer's units.
  void map() {
    eye_ = mapped(eye_);
    light_ = mapped(light_);
    for (double& side : screen_) side *= scale_;
    for (BlockBody& body : bodies_) {
      body.centre = mapped(body.centre);
      body.radius *= scale_;
      body.velocity = {scale_ * body.velocity[0], -scale_ * body.velocity[1],
                       scale_ * body.velocity[2]};
    }
    const Vector3 low = mapped(box_.low), high = mapped(box_.high);
    program_.box = {{low[0], high[1], low[2]}, {high[0], low[1], high[2]}};
    program_.eye = floats(eye_);
    program_.light = floats(light_);
    program_.screen = {static_cast<float>(screen_[0]), static_cast<float>(screen_[1])};
    program_.set_bodies(bodies_);
  }

  // What the renderer's numbers cannot hold.
  void check() {
    const Vector3 corner{screen_[0] / 2 + std::abs(eye_[0]), screen_[1] / 2 + std::abs(eye_[1]),
                         eye_[2]};
    if (f2i(program_.eye[2]) == 0)
      faults_.add(eye_at_, "the eye is on the screen", "move it away: z is smaller in front of it");
    fits(eye_at_, "the eye", {eye_, eye_});
    if (square(corner) >= MaxSquare)
      faults_.add(screen_at_.line ? screen_at_ : eye_at_,
                  fmt::format("from the eye to a corner of the screen it is {:.4g}, scaled",
                              length(corner)),
                  "below 32; make scale, the screen or the distance smaller");
    if (!fits(light_at_, "the light", {light_, light_})) return;
    for (std::size_t n = 0; n < bodies_.size(); ++n) check(n);
    if (!faults_.none()) return;
    for (std::size_t n = 0; n < bodies_.size(); ++n)
      for (std::size_t m = 0; m < n; ++m) check_pair(m, n);
  }
  /// Where the middle of a sphere may come: one that moves may push any other.
  MotionBox reach(const BlockBody& body) const {
    MotionBox r{body.centre, body.centre};
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = program_.box.low[k], high = program_.box.high[k];
      const double inside = std::clamp(body.centre[k], low, high);
      r.low[k] = std::min(r.low[k], moves(bodies_) ? low : inside);
      r.high[k] = std::max(r.high[k], moves(bodies_) ? high : inside);
    }
    return r;
  }
  /// From any place of one to any of the other.
  static double farthest(const MotionBox& a, const MotionBox& b) {
    Vector3 way;
    for (std::size_t k = 0; k < 3; ++k)
      way[k] = std::max(std::abs(a.high[k] - b.low[k]), std::abs(b.high[k] - a.low[k]));
    return length(way);
  }
  bool fits(const Place& at, const char* what, const MotionBox& reach) {
    for (const Vector3& p : {reach.low, reach.high})
      for (const double each : p) {
        if (std::abs(each) < MaxCoordinate) continue;
        faults_.add(at, fmt::format("{} has a coordinate of {:g}, scaled", what, each),
                    "below 256 after scaling; make scale or the coordinate smaller");
        return false;
      }
    return true;
  }
  void check(std::size_t n) {
    const BlockBody& body = bodies_[n];
    const double radius = body.radius;
    const MotionBox all = reach(body);
    if (!fits(sphere_at_[n], "the sphere", all)) return;
    if (radius * radius >= MaxDiscriminant || radius < MinRadius)
      faults_.add(radius_at_[n], fmt::format("'radius' is {:g}, scaled", radius),
                  "1/64 and more and below 2.828: the root is of numbers below 8");
    Vector3 from_eye, nearest;
    for (std::size_t k = 0; k < 3; ++k) {
      from_eye[k] = body.centre[k] - eye_[k];
      nearest[k] = std::clamp(eye_[k], all.low[k], all.high[k]) - eye_[k];
    }
    if (length(from_eye) < radius)
      faults_.add(sphere_at_[n], "the eye is inside the sphere",
                  "move one of them: what is hit from inside is not seen");
    else if (length(nearest) < radius)
      faults_.warn(sphere_at_[n], "the sphere can come around the eye",
                   "what is hit from inside is not seen; move the eye or a wall of the [box]");
    const double to_eye = farthest(all, {eye_, eye_});
    if (to_eye * to_eye >= MaxWay)
      faults_.add(sphere_at_[n],
                  fmt::format("from the eye to the sphere it is up to {:.4g}, scaled", to_eye),
                  "below 45.25; make scale, the box or the distance smaller");
    const double to_light = farthest(all, {light_, light_}) + radius;
    if (to_light * to_light >= MaxSquare)
      faults_.add(light_at_.line ? light_at_ : sphere_at_[n],
                  fmt::format("from the light to the sphere in line {} it is up to {:.4g}, scaled",
                              sphere_at_[n].line, to_light),
                  "below 32; make scale, the box or the distance smaller");
  }
  /// A ray goes from one to the other.
  void check_pair(std::size_t m, std::size_t n) {
    const double way = farthest(reach(bodies_[m]), reach(bodies_[n])) +
                       std::max(bodies_[m].radius, bodies_[n].radius);
    if (way * way >= MaxWay)
      faults_.add(sphere_at_[n],
                  fmt::format("to the sphere in line {} it is up to {:.4g}, scaled",
                              sphere_at_[m].line, way),
                  "below 45.25; make scale, the box or the distance smaller");
  }

  BlockProgram& program_;
  double scale_ = 1, screen_z_ = 0;
  Vector3 eye_{0, 0, -7}, light_{-8, -9, -9};
  std::array<double, 2> screen_{8, 6};
  MotionBox box_{{-6, -5, 0}, {6, 5, 11}};
  std::vector<BlockBody> bodies_;
  Place eye_at_{1, 1}, light_at_{}, screen_at_{};
  std::vector<Place> sphere_at_, radius_at_;
};

}  // namespace

const racebeam::engine& BlockScene::engine() const { return block_engine(); }

std::string BlockScene::counts() const { return counted(program_.bodies.size(), "sphere"); }

std::vector<SceneFact> BlockScene::facts() const {
  return {{"spheres", static_cast<int>(program_.bodies.size())},
          {"pictures", pictures_},
          {"screen", fmt::format("{:g} x {:g}", program_.screen[0], program_.screen[1])},
          {"moves", moves(program_.bodies)}};
}

std::shared_ptr<const AnyScene> read_block_scene(const SceneText& file, Faults& faults) {
  const auto scene = std::make_shared<BlockScene>();
  scene->name_ = file.name;
  const TableReader top(file.root, "", faults, block_scene_keys());
  top.read("name", scene->name_);
  top.read("frames", 1, MaxPictures, scene->pictures_);
  Reader(file, scene->program_, faults).read(top);
  if (!faults.none()) return nullptr;
  return scene;
}

}  // namespace racebeam
