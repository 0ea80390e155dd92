// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/chip_wires.h"

#include <map>
#include <stdexcept>

namespace racebeam {

namespace {

const std::map<std::string, int chip_wires::*> wires = {
    {"rst_n", &chip_wires::rst_n},
    {"speed", &chip_wires::speed},
    {"no_interlace", &chip_wires::no_interlace},
    {"x2", &chip_wires::x2},
    {"y", &chip_wires::y},
    {"hsync_n", &chip_wires::hsync_n},
    {"vsync_n", &chip_wires::vsync_n},
    {"active", &chip_wires::active},
    {"h_active", &chip_wires::h_active},
    {"consume", &chip_wires::consume},
    {"line_end", &chip_wires::line_end},
    {"active_start", &chip_wires::active_start},
    {"frame_end", &chip_wires::frame_end},
    {"nav_line", &chip_wires::nav_line},
    {"angle", &chip_wires::angle},
    {"frame", &chip_wires::frame},
    {"scene_flags", &chip_wires::scene_flags},
    {"palette", &chip_wires::palette},
    {"colours", &chip_wires::colours},
    {"shading_b", &chip_wires::shading_b},
    {"scene_interlace", &chip_wires::scene_interlace},
    {"lock", &chip_wires::lock},
    {"inverse", &chip_wires::inverse},
    {"nav_reset", &chip_wires::nav_reset},
    {"start_room", &chip_wires::start_room},
    {"src", &chip_wires::src},
    {"run", &chip_wires::run},
    {"tracer_reset", &chip_wires::tracer_reset},
    {"load", &chip_wires::load},
    {"load_zero", &chip_wires::load_zero},
    {"ext", &chip_wires::ext},
    {"copy_ext", &chip_wires::copy_ext},
    {"idx_load", &chip_wires::idx_load},
    {"ext_sign", &chip_wires::ext_sign},
    {"axis_mask", &chip_wires::axis_mask},
    {"idx_start", &chip_wires::idx_start},
    {"i2_init", &chip_wires::i2_init},
    {"state", &chip_wires::state},
    {"descend", &chip_wires::descend},
    {"climb", &chip_wires::climb},
    {"restart", &chip_wires::restart},
    {"emit", &chip_wires::emit},
    {"cur", &chip_wires::cur},
    {"leave", &chip_wires::leave},
    {"ray_signs", &chip_wires::ray_signs},
    {"len_m1", &chip_wires::len_m1},
    {"idx2", &chip_wires::idx2},
    {"i2", &chip_wires::i2},
    {"step", &chip_wires::step},
    {"neg", &chip_wires::neg},
    {"copy_sub", &chip_wires::copy_sub},
    {"push_en", &chip_wires::push_en},
    {"step_size", &chip_wires::step_size},
    {"sp", &chip_wires::sp},
    {"sd", &chip_wires::sd},
    {"line_done", &chip_wires::line_done},
    {"top_tag", &chip_wires::top_tag},
    {"top_i2", &chip_wires::top_i2},
    {"fread", &chip_wires::fread},
    {"dec", &chip_wires::dec},
    {"mask", &chip_wires::mask},
    {"tag", &chip_wires::tag},
    {"wall", &chip_wires::wall},
    {"second", &chip_wires::second},
    {"fwrite", &chip_wires::fwrite},
    {"fdata", &chip_wires::fdata},
    {"hit_face", &chip_wires::hit_face},
    {"room", &chip_wires::room},
    {"look_axis", &chip_wires::look_axis},
    {"look_way", &chip_wires::look_way},
    {"look_signs", &chip_wires::look_signs},
    {"look_portal", &chip_wires::look_portal},
    {"neighbour", &chip_wires::neighbour},
    {"back", &chip_wires::back},
    {"edges", &chip_wires::edges},
    {"nav_room", &chip_wires::nav_room},
    {"nav_axis", &chip_wires::nav_axis},
    {"nav_portal", &chip_wires::nav_portal},
    {"nav_negative", &chip_wires::nav_negative},
    {"nav_move", &chip_wires::nav_move},
    {"nav_op", &chip_wires::nav_op},
    {"ack", &chip_wires::ack},
    {"starving", &chip_wires::starving},
    {"display", &chip_wires::display},
    {"value", &chip_wires::value},
    {"display_half", &chip_wires::display_half},
    {"half", &chip_wires::half},
    {"fill", &chip_wires::fill},
    {"uo", &chip_wires::uo},
    {"pwm", &chip_wires::pwm}};
const std::map<std::string, vec3 chip_wires::*> axes_of_wires = {
    {"start", &chip_wires::start},
    {"velocity", &chip_wires::velocity},
    {"delta", &chip_wires::delta},
    {"dr1", &chip_wires::dr1},
    {"dr2", &chip_wires::dr2},
    {"corner", &chip_wires::corner},
    {"half_size", &chip_wires::half_size},
    {"position", &chip_wires::position},
    {"nav_position", &chip_wires::nav_position}};

/// A port's name without _i or _o; rst_n of rst_ni.
std::string wire_name(const std::string& port) {
  const std::string end = port.size() > 3 ? port.substr(port.size() - 3) : "";
  if (end == "_ni" || end == "_no") return port.substr(0, port.size() - 1);
  return port.substr(0, port.size() > 2 ? port.size() - 2 : 0);
}

}  // namespace

int& chip_wires::at(const std::string& port) {
  const std::string name = wire_name(port);
  if (const auto found = wires.find(name); found != wires.end()) return this->*found->second;
  const std::size_t stem = name.size() > 2 ? name.size() - 2 : 0;
  const auto found = axes_of_wires.find(name.substr(0, stem));
  if (found == axes_of_wires.end() || name[stem] != '_' || name[stem + 1] < 'x' ||
      name[stem + 1] > 'z')
    throw std::out_of_range("the chip has no wire at a port " + port);
  return (this->*found->second)[name[stem + 1] - 'x'];
}

}  // namespace racebeam
