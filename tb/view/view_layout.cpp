// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_layout.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

constexpr double Steps = 4;           // of a scale between two whole ones
constexpr double WholeEnough = 0.85;  // of the largest scale
constexpr int FrameWidth = 16, TitleHeight = 48;
constexpr int TitleShare = 20;  // of the height, on screens with large letters

int near_side(int place, int size, int screen_place, int screen_size) {
  return std::max(std::min(place, screen_place + screen_size - size), screen_place);
}

}  // namespace

double fit_scale(Extent picture, Extent room) {
  const double most = std::min(static_cast<double>(room.width) / picture.width,
                               static_cast<double>(room.height) / picture.height);
  if (most < 1) return most;
  const double stepped = std::floor(most * Steps) / Steps, whole = std::floor(most);
  return whole >= WholeEnough * stepped ? whole : stepped;
}

Extent scaled(Extent picture, double scale) {
  return {std::max(static_cast<int>(std::lround(picture.width * scale)), 1),
          std::max(static_cast<int>(std::lround(picture.height * scale)), 1)};
}

Extent window_room(Extent screen) {
  return {std::max(screen.width - FrameWidth, 1),
          std::max(screen.height - std::max(TitleHeight, screen.height / TitleShare), 1)};
}

Box picture_in(Extent picture, Extent window) {
  const Extent size = scaled(picture, fit_scale(picture, window));
  return {(window.width - size.width) / 2, (window.height - size.height) / 2, size};
}

Box kept_within(const Box& window, const Box& screen) {
  return {near_side(window.left, window.size.width, screen.left, screen.size.width),
          near_side(window.top, window.size.height, screen.top, screen.size.height), window.size};
}

}  // namespace racebeam
