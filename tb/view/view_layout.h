// How large a viewer's picture is shown, and where: sizes and places, without any window.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Pixels of a screen or of a picture.
struct Extent {
  int width = 0, height = 0;
  bool operator==(const Extent& o) const { return width == o.width && height == o.height; }
  bool operator!=(const Extent& o) const { return !(*this == o); }
};

struct Box {
  int left = 0, top = 0;
  Extent size;
};

/// The size of a picture's pixel in a room: the largest multiple of a quarter that fits, so that
/// lines that alternate keep an even pattern; a whole number instead if that is at most 15 %
/// smaller, which shows each pixel as it is. In a room smaller than the picture, what fits.
double fit_scale(Extent picture, Extent room);

Extent scaled(Extent picture, double scale);

/// What a window may take of a screen whose bars are left out: room for a title and a frame stays.
Extent window_room(Extent screen);

/// The picture in the middle of a window, at fit_scale().
Box picture_in(Extent picture, Extent window);

/// A box of the window's size that lies in `screen`, as near to the window as can be.
Box kept_within(const Box& window, const Box& screen);

}  // namespace racebeam
