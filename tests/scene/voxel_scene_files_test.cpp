// The scenes of the voxel tracer that come with the program; and that rays end in worlds of rooms
// and of spheres where they end in the rooms and spheres themselves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "sc/sphere/first_hit.h"
#include "sc/voxel/voxel_rays.h"
#include "tb/base/whole_file.h"
#include "tb/scene/scene_reader.h"
#include "tb/scene/sphere_scene.h"
#include "tb/scene/starter_scene.h"
#include "tests/scene/voxel_text.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;

const fs::path Scenes = RACEBEAM_SOURCE_DIR "/scenes";

VoxelProgram program_of(const fs::path& path) {
  return VoxelText(whole_file(path.string()), path.parent_path().string()).good();
}

TEST(VoxelSceneFilesTest, AreGood) {
  int files = 0;
  for (const auto& file : fs::directory_iterator(Scenes / "voxel"))
    if (file.path().extension() == ".toml") {
      SCOPED_TRACE(file.path());
      EXPECT_FALSE(program_of(file.path()).columns.empty());
      ++files;
    }
  EXPECT_GE(files, 4);
}

TEST(VoxelSceneFilesTest, TheStarterIsGood) {
  EXPECT_FALSE(VoxelText(starter_voxel_scene()).good().columns.empty());
}

constexpr int Nothing = -1;

/// What the rays of picture 0 meet, as its objects.
class VoxelPicture {
 public:
  VoxelPicture(const fs::path& path, int leaf_steps) : program_(program_of(path)) {
    knobs_.size_x = program_.size[0];
    knobs_.size_y = program_.size[1];
    knobs_.size_z = program_.size[2];
    knobs_.voxel_x = program_.voxel[0];
    knobs_.voxel_y = program_.voxel[1];
    knobs_.voxel_z = program_.voxel[2];
    knobs_.leaf_steps = leaf_steps;
    world_ = std::make_unique<voxel_world>(voxel_levels(knobs_), program_.columns);
  }

  voxel_ray ray(int x, int y) const {
    const voxel_view& view = program_.view(0);
    voxel_ray ray{view.origin, {}};
    for (std::size_t k = 0; k < 3; ++k)
      ray.direction[k] = (view.d00[k] + x * view.dx[k] + y * view.dy[k]) >> 8;
    return ray;
  }

  int object(int x, int y) {
    const voxel_end end =
        voxel_walk(*world_, knobs_, ray(x, y), {knobs_.max_outer, knobs_.max_inner}, walked_);
    if (end.kind != VoxelHit) return Nothing;
    const int column_x = end.position[0] >> 8, column_y = end.position[1] >> 8;
    const bool upper = end.position[2] >> 8 >= world_->column(column_x, column_y).low;
    return program_.object(world_->column_address(column_x, column_y), upper);
  }

  const VoxelProgram& program() const { return program_; }

  /// Share of pixels away from edges whose object is another than `expected(x, y)`.
  template <class Expected>
  double wrong(const Expected& expected) {
    constexpr int Step = 3;
    int count = 0, wrong = 0;
    for (int y = 1; y < program_.height - 1; y += Step)
      for (int x = 1; x < program_.width - 1; x += Step) {
        const int here = expected(x, y);
        if (expected(x - 1, y - 1) != here || expected(x + 1, y - 1) != here ||
            expected(x - 1, y + 1) != here || expected(x + 1, y + 1) != here)
          continue;
        ++count;
        wrong += seen(object(x, y)) != here;
      }
    EXPECT_GT(count, program_.width * program_.height / Step / Step / 2);
    return double(wrong) / count;
  }

  virtual int seen(int object) const { return object; }
  virtual ~VoxelPicture() = default;

 private:
  VoxelProgram program_;
  voxel_knobs knobs_;
  std::unique_ptr<voxel_world> world_;
  voxel_walked walked_;
};

TEST(VoxelSceneFilesTest, BallsAreSeenWhereTheyAre) {
  struct Balls : VoxelPicture {
    using VoxelPicture::VoxelPicture;
    int seen(int object) const override { return object < FirstPlane ? object : Nothing; }
  };
  const fs::path path = Scenes / "common/balls.toml";
  Balls picture(path, 1);
  // In the file's units, from its eye: the world is four times as large.
  const std::vector<Vector3> centres = {{-16, 9, 46},  {-5, 11, 42}, {6, 8, 48},  {17, 10, 44},
                                        {-11, -6, 58}, {11, -8, 60}, {0, -2, 55}, {0, -17, 65}};
  const std::vector<double> radii = {5, 4, 5, 4, 6, 6, 4, 6};
  const auto nearest = [&](int x, int y) {
    const Vector3 d{x - 256.0, y - 240.0, 288};
    int found = Nothing;
    double t_found = 1e9;
    for (std::size_t n = 0; n < centres.size(); ++n) {
      const double a = dot(d, d), b = dot(d, centres[n]);
      const double root = b * b - a * (dot(centres[n], centres[n]) - radii[n] * radii[n]);
      if (root < 0 || (b - std::sqrt(root)) / a >= t_found) continue;
      t_found = (b - std::sqrt(root)) / a;
      found = static_cast<int>(n);
    }
    return found;
  };
  EXPECT_LT(picture.wrong(nearest), 0.02);
}

TEST(VoxelSceneFilesTest, WallsOfTheHallAreSeenWhereTheyAre) {
  struct Hall : VoxelPicture {
    using VoxelPicture::VoxelPicture;
    int seen(int object) const override { return object % FaceCount; }
  };
  const fs::path path = Scenes / "common/hall.toml";
  Hall picture(path, 2);
  std::string text = whole_file(path.string());
  const SceneResult rooms = read_scene(text.substr(0, text.find("[for.")), "hall");
  ASSERT_TRUE(rooms.faults.none()) << rooms.faults.text("hall");
  const std::vector<Room>& all = rooms.scene.rooms;
  constexpr int Base = 8;  // of y = 0, the floor, in the world
  // The face by which a ray leaves all rooms, in the file's axes.
  const auto wall = [&](int x, int y) {
    const voxel_ray ray = picture.ray(x, y);
    const auto coordinate = [&](int axis) {  // modulo the world it is left of 0
      const double at = ray.origin[axis] / 256.0;
      return at > picture.program().size[axis] / 2 ? at - picture.program().size[axis] : at;
    };
    Vector3 at{coordinate(0), Base - ray.origin[2] / 256.0, coordinate(1)};
    const Vector3 d{ray.direction[0] + 0.5, -ray.direction[2] - 0.5, ray.direction[1] + 0.5};
    const auto inside = [&](const Room& room, const Vector3& p) {
      for (int k = 0; k < 3; ++k)
        if (p[k] < room.low(k) || p[k] > room.high(k)) return false;
      return true;
    };
    int face = Nothing;
    for (std::size_t n = 0; n < all.size();) {
      if (!inside(all[n], at)) {
        ++n;
        continue;
      }
      double t = 1e9;
      for (int k = 0; k < 3; ++k) {
        const double border = ((d[k] > 0 ? all[n].high(k) : all[n].low(k)) - at[k]) / d[k];
        if (border >= t) continue;
        t = border;
        face = 2 * k + (d[k] < 0);
      }
      t += 1e-9;  // just behind the border
      for (int k = 0; k < 3; ++k) at[k] += t * d[k];
      n = 0;
    }
    return face;
  };
  EXPECT_LT(picture.wrong(wall), 0.02);
}

}  // namespace
}  // namespace racebeam
