// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/voxel_hands.h"

namespace racebeam {

namespace {

template <class Wires>
void put(Wires& to, const vec3& value) {
  to.x.write(static_cast<std::uint32_t>(value[0]));
  to.y.write(static_cast<std::uint32_t>(value[1]));
  to.z.write(static_cast<std::uint32_t>(value[2]));
}

}  // namespace

VoxelHands::VoxelHands(voxel_chip& chip, const VoxelProgram& program, const voxel_knobs& k)
    : PictureHands(chip, voxel_knobs::clocks_per_pixel), chip_(chip), show_(program, k) {}

void VoxelHands::go_to(int picture) {
  show_.go_to(picture);
  if (picture > 0) chip_.deposit(show_.columns());
}

void VoxelHands::begin(int) {
  deeds_ = show_.next();
  deed_ = 0;
  step_ = 0;
  drawn_ = false;
  put_view();
  put_deed();
}

void VoxelHands::put_view() {
  const voxel_view& view = show_.view();
  voxel_chip::host_wires& at = chip_.host();
  put(at.origin, view.origin);
  put(at.d00, view.d00);
  put(at.dx, view.dx);
  put(at.dy, view.dy);
  put(at.light, view.light);
}

// The wires of the next clock.
void VoxelHands::put_deed() {
  voxel_chip::host_wires& at = chip_.host();
  const bool draws = deed_ == deeds_.size();
  const VoxelDeed deed = draws ? VoxelDeed{VoxelDeed::Frame} : deeds_[deed_];
  const voxel_rectangle& r = deed.rectangle;
  const bool colours = deed.kind == VoxelDeed::Colours, columns = deed.kind == VoxelDeed::Columns;
  at.palette_write.write(colours);
  if (colours) {
    at.palette_index.write(step_);
    at.palette_colour.write(static_cast<unsigned>(show_.palette()[step_]));
  }
  at.column_write.write(columns);
  if (columns) {
    const auto width = static_cast<std::uint64_t>(r.x_high - r.x_low);
    const std::uint32_t address = show_.address(r.x_low + static_cast<int>(step_ % width),
                                                r.y_low + static_cast<int>(step_ / width));
    at.column_address.write(address);
    at.column_data.write(show_.columns()[address]);
  }
  const bool builds = deed.kind == VoxelDeed::Build && step_ == 0;
  at.build.write(builds);
  if (builds) {
    at.rect_x_low.write(static_cast<unsigned>(r.x_low));
    at.rect_y_low.write(static_cast<unsigned>(r.y_low));
    at.rect_x_high.write(static_cast<unsigned>(r.x_high));
    at.rect_y_high.write(static_cast<unsigned>(r.y_high));
  }
  at.start.write(draws && step_ == 0);
}

bool VoxelHands::done(const VoxelDeed& deed) {
  const voxel_rectangle& r = deed.rectangle;
  switch (deed.kind) {
    case VoxelDeed::Colours: return step_ == VoxelPaletteEntries;
    case VoxelDeed::Columns:
      return step_ == static_cast<std::uint64_t>(r.x_high - r.x_low) *
                          static_cast<std::uint64_t>(r.y_high - r.y_low);
    case VoxelDeed::Build: return step_ > 1 && chip_.host().built.read();
    case VoxelDeed::Frame: return frame_is_over();
  }
  return true;
}

bool VoxelHands::send() {
  ++step_;
  if (deed_ < deeds_.size()) {
    if (done(deeds_[deed_])) {
      do ++deed_;
      while (deed_ < deeds_.size() && deeds_[deed_].kind == VoxelDeed::Frame && frame_is_over());
      step_ = 0;
    }
    put_deed();
    return false;
  }
  // The last word is in the buffer a clock later.
  const bool over = drawn_;
  chip_.host().start.write(false);
  drawn_ |= chip_.host().picture_done.read();
  return over;
}

std::unique_ptr<Surroundings> make_voxel_hands(wired_chip& chip,
                                               const WiredBench::Setting& setting) {
  return std::make_unique<VoxelHands>(static_cast<voxel_chip&>(chip),
                                      voxel_program_of(setting.scene), setting.k);
}

}  // namespace racebeam
