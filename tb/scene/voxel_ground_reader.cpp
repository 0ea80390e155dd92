// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_ground_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sc/voxel/voxel_levels.h"
#include "sc/voxel/voxel_world.h"
#include "tb/scene/table_reader.h"
#include "tb/scene/voxel_scene.h"
#include "tb/scene/voxel_solids.h"

namespace racebeam {

namespace {

constexpr int MinHeight = 16;  // the palette has so many heights
const std::vector<std::string> Functions = {"tiny", "hills", "canyon"};
constexpr const char* Sources[] = {"function", "picture", "rooms", "spheres"};

double gibibytes(double words) { return words * 4 / (1 << 30); }

/// A colour of five bits a channel.
std::uint32_t rgb_of(const sphere_colour& c) {
  std::uint32_t rgb = 0;
  for (std::size_t k = 0; k < 3; ++k)
    rgb = rgb << 8 | static_cast<std::uint32_t>((c[k] * 255 + 15) / 31);
  return rgb;
}

int distance(std::uint32_t a, std::uint32_t b) {
  int sum = 0;
  for (const int shift : {16, 8, 0}) {
    const int by = static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255);
    sum += by * by;
  }
  return sum;
}

/// A material for each sphere, from the second on; if there are too many colours, the nearest.
std::vector<int> materials_of(const std::vector<MovingSphere>& spheres, VoxelColours& colours) {
  std::vector<int> materials;
  std::vector<std::uint32_t> known;
  for (const MovingSphere& sphere : spheres) {
    const std::uint32_t colour = rgb_of(sphere.colour);
    const auto nearest =
        std::min_element(known.begin(), known.end(), [&](std::uint32_t a, std::uint32_t b) {
          return distance(a, colour) < distance(b, colour);
        });
    const bool fresh = nearest == known.end() || *nearest != colour;
    const std::size_t number = fresh && known.size() + 1 < colours.size()
                                   ? known.size()
                                   : static_cast<std::size_t>(nearest - known.begin());
    if (number == known.size()) {
      known.push_back(colour);
      colours[number + 1] = {colour >> 1 & 0x7f7f7f, colour};
    }
    materials.push_back(static_cast<int>(number) + 1);
  }
  return materials;
}

class Reader {
 public:
  Reader(const VoxelFile& split, const SceneText& file, VoxelGround& ground, Faults& faults)
      : split_(split), file_(file), ground_(ground), faults_(faults) {}

  void read() {
    static const TomlNode none;
    const TomlNode* const node = split_.own.find("terrain");
    const VoxelOther own = read_own_scene(split_, file_, faults_);
    const bool of_another = split_.rooms || split_.spheres;
    if (!node && !of_another)
      return faults_.add({1, 1}, "the scene has no [terrain]",
                         "write [terrain] and below it function = \"hills\"");
    if (node) ground_.place = node->place;
    const TableReader table(node ? *node : none, "terrain", faults_, voxel_scene_keys());
    const TomlNode* const source = source_of(table);
    if (!source && !of_another && node->kind == TomlNode::Table)
      faults_.add(node->place, "the terrain is made from nothing",
                  "write function = \"hills\", or picture, rooms or spheres = \"FILE\"");
    if (source) ground_.place = source->place;
    int function = -1;
    if (table.read_choice("function", Functions, function) && function == 0)
      ground_.size = {64, 64, 32};
    const bool sized = read_size(table);
    read_mapping(table);
    if (function >= 0) read_function(table, function, sized);
    else if (source && source == table.find("picture")) read_pictures(table, sized);
    else if (source && source == table.find("rooms"))
      take(read_named_rooms(*source, file_, faults_), sized);
    else if (source && source == table.find("spheres"))
      take(read_named_spheres(*source, file_, faults_), sized);
    else if (!source) take(own, sized);
  }

 private:
  /// nullptr if there is none.
  const TomlNode* source_of(const TableReader& table) const {
    const TomlNode* source = nullptr;
    for (const char* key : Sources) {
      const TomlNode* const node = table.find(key);
      if (node && source)
        faults_.add(node->place, std::string("the terrain is made from '") + key + "' too",
                    "leave one of function, picture, rooms and spheres");
      else if (node) source = node;
    }
    return source;
  }

  bool read_size(const TableReader& table) {
    const int before = faults_.count();
    Vector size{ground_.size[0], ground_.size[1], ground_.size[2]}, voxel{1, 4, 1};
    table.read("size", 1, VoxelMaxSide, size);
    table.read("voxel", 1, VoxelMaxVoxel, voxel);
    ground_.size = {size[0], size[1], size[2]};
    ground_.voxel = {voxel[0], voxel[1], voxel[2]};
    const TomlNode* const sized = table.find("size");
    const Place at = sized ? sized->place : table.place();
    if (size[2] < MinHeight || size[2] > VoxelMaxHeight || size[2] & (size[2] - 1))
      faults_.add(at, fmt::format("the world is {} high", size[2]), "16, 32, 64, 128 or 256");
    if (faults_.count() != before) return false;
    try {
      check_memory(voxel_levels(ground_.size, ground_.voxel), at);
    } catch (const std::invalid_argument& wrong) {
      const std::string text = wrong.what();
      const std::size_t cut = text.find("; ");
      const TomlNode* const voxels = table.find("voxel");
      const bool of_voxel = text.rfind("a voxel", 0) == 0 && voxels;
      std::string help = cut == std::string::npos ? "" : text.substr(cut + 2);
      help.resize(std::min(help.size(), help.find(", or have fewer")));  // no key of a scene
      faults_.add(of_voxel ? voxels->place : at, text.substr(0, cut), help);
    }
    return faults_.count() == before;
  }

  void check_memory(const voxel_levels& levels, Place at) {
    const double columns = double(ground_.size[0]) * ground_.size[1];
    const double words = levels.words();
    if (columns <= 1 << VoxelColumnBits && words <= 1 << VoxelWordBits) return;
    faults_.add(at,
                fmt::format("the world needs {:.2f} GiB: {:.2f} for columns and {:.2f} for voxels",
                            gibibytes(columns + words), gibibytes(columns), gibibytes(words)),
                "columns have 0.125 GiB, voxels 0.5: make size smaller or voxel larger");
  }

  void read_mapping(const TableReader& table) {
    table.read("scale", 1.0 / 64, 64.0, scale_);
    table.read("floor", 0, VoxelMaxHeight - 1, floor_);
    int base = 0;
    if (table.read("base", -100000, 100000, base)) base_ = base;
    if (floor_ > voxel_top(ground_.size))
      faults_.add(table.find("floor") ? table.find("floor")->place : table.place(),
                  fmt::format("the floor is at {}; the world is {} high", floor_, ground_.size[2]),
                  "make floor smaller");
  }

  void read_function(const TableReader& table, int function, bool sized) {
    HillsTerrain hills;
    CanyonTerrain canyon;
    table.read("seed", 0, 1000000, hills.seed);
    table.read("octaves", 1, 8, hills.octaves);
    table.read("posts", 0, 1000000, hills.posts);
    table.read("caves", hills.caves);
    canyon.seed = hills.seed;
    table.read("offset", 0, VoxelMaxSide - 1, canyon.offset);
    ground_.what = Functions[static_cast<std::size_t>(function)];
    if (!sized || !faults_.none()) return;
    ground_.columns = function == 0   ? tiny_terrain(ground_.size)
                      : function == 1 ? hills_terrain(ground_.size, hills)
                                      : canyon_terrain(ground_.size, canyon);
  }

  /// nothing, and a fault, if it cannot be used.
  std::optional<GreyPicture> picture(const TableReader& table, const char* key, bool sized) {
    std::string name;
    if (!table.read(key, name)) return {};
    const Place at = table.find(key)->place;
    GreyPicture grey;
    const std::string wrong = read_grey_picture(beside(file_, name), grey);
    if (!wrong.empty()) {
      faults_.add(at, quoted(name) + " cannot be read: " + wrong,
                  "name a grey picture of 8 or 16 bits that lies beside the scene file");
      return {};
    }
    const vec3& size = ground_.size;
    if (sized && (grey.width != size[0] || grey.height != size[1])) {
      faults_.add(at,
                  fmt::format("{} is {} x {}; the world is {} x {}", quoted(name), grey.width,
                              grey.height, size[0], size[1]),
                  fmt::format("write size = [{}, {}, {}], or name a picture of the world's size",
                              grey.width, grey.height, size[2]));
      return {};
    }
    return grey;
  }

  void read_pictures(const TableReader& table, bool sized) {
    ground_.what = "picture";
    const auto low = picture(table, "picture", sized), middle = picture(table, "middle", sized),
               high = picture(table, "high", sized), materials = picture(table, "materials", sized);
    for (const auto& [one, other] : {std::pair("middle", "high"), std::pair("high", "middle")})
      if (table.find(one) && !table.find(other))
        faults_.add(table.find(one)->place, fmt::format("there is '{}' without '{}'", one, other),
                    "a second layer begins at 'middle' and ends at 'high': name both pictures");
    if (!sized || !faults_.none()) return;
    PictureTerrain all{&*low};
    if (middle) all.middle = &*middle;
    if (high) all.high = &*high;
    if (materials) all.materials = &*materials;
    ground_.columns = picture_terrain(ground_.size, all);
    if (middle) check_layers(table.find("middle")->place);
  }

  void check_layers(Place at) {
    const auto wrong = [](std::uint32_t word) {
      const voxel_column c = unpacked_column(word);
      return c.low > c.middle || c.middle > c.high;
    };
    const auto first = std::find_if(ground_.columns.begin(), ground_.columns.end(), wrong);
    if (first == ground_.columns.end()) return;
    const voxel_column c = unpacked_column(*first);
    const auto n = first - ground_.columns.begin();
    faults_.add(at,
                fmt::format("column ({}, {}) has low {}, middle {} and high {}",
                            n % ground_.size[0], n / ground_.size[0], c.low, c.middle, c.high),
                "none may be below the one before it; where 'high' is black is no second layer");
  }

  void take(const VoxelOther& other, bool sized) {
    if (!other.any() || !sized || !faults_.none()) return;
    if (other.rooms) take_rooms(*other.rooms);
    else take_spheres(*other.spheres, other.names);
  }

  void put(VoxelSolids solids) {
    ground_.columns = std::move(solids.columns);
    ground_.objects = std::move(solids.objects);
  }

  void take_rooms(const BeamScene& scene) {
    const std::vector<Room>& rooms = scene.file.rooms;
    const VoxelMapping map{scale_, base_ ? *base_ : base_of_rooms(rooms, scale_, floor_),
                           ground_.size};
    ground_.what = "rooms";
    put(room_columns(scene.file, map, ground_.place, faults_));
    ground_.pinholes = room_pinholes(scene, map);
    ground_.pictures = scene.frames();
  }

  void take_spheres(const SphereScene& scene, const std::vector<std::string>& names) {
    constexpr int Wide = 1 << 5;  // the switch for 512 x 480
    const SphereProgram& program = scene.tables();
    const VoxelMapping map{scale_, base_ ? *base_ : base_of_spheres(program.moving, scale_, floor_),
                           ground_.size};
    ground_.what = "spheres";
    put(sphere_columns(program.moving, names, materials_of(program.moving, ground_.colours), floor_,
                       map, ground_.place, faults_));
    ground_.pinholes = {sphere_pinhole(program, map)};
    ground_.pictures = scene.frames();
    ground_.shown = program.modes & Wide ? std::array{512, 480} : std::array{320, 240};
    for (const MovingSphere& sphere : program.moving)
      if (sphere.velocity != Vector3{})
        return faults_.warn(ground_.place, "the spheres move, but the world is built once",
                            "they stay where picture 0 has them");
  }

  const VoxelFile& split_;
  const SceneText& file_;
  VoxelGround& ground_;
  Faults& faults_;
  double scale_ = 1;
  int floor_ = 8;
  std::optional<int> base_;
};

}  // namespace

VoxelGround read_voxel_ground(const VoxelFile& split, const SceneText& file, Faults& faults) {
  VoxelGround ground;
  Reader(split, file, ground, faults).read();
  return ground;
}

}  // namespace racebeam
