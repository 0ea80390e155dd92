// Clocks that the sphere tracer needs for each pixel of four spheres and a light, 512 x 480,
// without reflections: its states counted in a plain loop, from its rules alone, for tests of what
// is behind it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace racebeam {

/// Signed numbers of 24 bits, 12 of them behind the point; products have twice as many.
class FourClocks {
 public:
  static constexpr int Width = 512, Height = 480;

  /// Row by row.
  static std::vector<int> all() {
    std::vector<int> clocks;
    for (int y = 0; y < Height; ++y)
      for (int x = 0; x < Width; ++x) clocks.push_back(of_pixel(x, y));
    return clocks;
  }

 private:
  using Number = std::int64_t;
  using Vector = std::array<Number, 3>;
  struct Sphere {
    int x, y, z, r;

    Vector centre() const { return {fixed(x), fixed(y), fixed(z)}; }
    Number radius2() const { return fixed(fixed(r * r)); }
    Number inverse() const { return fixed(1) / r; }
  };
  static constexpr int Spheres = 4;
  static constexpr Sphere Objects[Spheres + 1] = {
      {-9, 0, 15, 5}, {9, 0, 15, 5}, {0, -9, 20, 5}, {0, 8, 10, 4}, {15, 15, -1, 2}};  // the light

  // Clocks of states, by what they do.
  static constexpr int Normalise = 1 + 7 + 6, Centre = 1, Along = 1, Front = 1, Chord = 1, Hit = 7,
                       Light = 1, Normal = 1, Lambert = 1, Shade = 1, NoMore = 1, Add = 1, Next = 1;

  static constexpr Number fixed(Number whole) { return whole * 4096; }
  static Number wrapped(Number n) { return ((n & 0xffffff) ^ 0x800000) - 0x800000; }
  static Number product(Number n) { return wrapped(n >> 12); }
  static Number dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Vector minus(const Vector& a, const Vector& b) {
    return {wrapped(a[0] - b[0]), wrapped(a[1] - b[1]), wrapped(a[2] - b[2])};
  }
  static Number root(Number n) {
    auto r = static_cast<Number>(std::sqrt(static_cast<double>(n << 12)));
    while (r * r > n << 12) --r;
    while ((r + 1) * (r + 1) <= n << 12) ++r;
    return r;
  }
  static Number length(const Vector& v) {
    const Number square = dot(v, v);
    return root(square >> 36 ? 0xffffff : square >> 12);
  }
  static Vector normalised(const Vector& v) {
    const Number n = length(v);
    return {wrapped(fixed(v[0]) / n), wrapped(fixed(v[1]) / n), wrapped(fixed(v[2]) / n)};
  }

  static int of_pixel(int x, int y) {
    const Vector eye{0, 0, fixed(-32)};
    const Vector ray = normalised({(fixed(x) >> 5) - fixed(Width / 2) / 32,
                                   (fixed(y) >> 5) - fixed(Height / 2) / 32, fixed(8 + 1)});
    int clocks = Normalise, hit = -1;
    Number nearest = 0;
    for (int n = 0; n <= Spheres; ++n) {
      clocks += Centre + Along + Front;
      const Vector centre = minus(Objects[n].centre(), eye);
      const Number sum = dot(ray, centre), along = product(sum);
      if (sum < 0) continue;
      clocks += Chord;
      const Number chord = along * along - dot(centre, centre) + Objects[n].radius2();
      if (chord < 0) continue;
      clocks += Hit;
      const Number t = along - root(chord >> 12 & 0xffffff);
      if (hit >= 0 && t >= nearest) continue;
      hit = n;
      nearest = t;
    }
    if (hit < 0) return clocks + Next;
    if (hit == Spheres) return clocks + Light + Add + Next;
    Vector point;
    for (int k = 0; k < 3; ++k) point[k] = wrapped(eye[k] + product(ray[k] * nearest));
    return clocks + Light + Normalise + of_shade(hit, point) + Add + Next;
  }

  static int of_shade(int hit, const Vector& point) {
    Vector to_light = minus(Objects[Spheres].centre(), point);
    for (Number& n : to_light) n >>= 4;
    const Number distance = length(to_light) << 4;
    const Vector light = normalised(to_light);
    Vector normal = minus(point, Objects[hit].centre());
    for (Number& n : normal) n = product(n * Objects[hit].inverse());
    int clocks = Normal + Lambert + Shade;
    if (dot(normal, light) < 0) return clocks;
    for (int n = 0; n < Spheres; ++n) {
      clocks += Centre + Along + Front;
      const Vector centre = minus(Objects[n].centre(), point);
      const Number sum = dot(light, centre), along = product(sum), square = dot(centre, centre);
      if (sum < 0) continue;
      if (n == hit || square < Objects[n].radius2()) return clocks;
      if (along > distance) continue;
      clocks += Chord;
      if (along * along - square + Objects[n].radius2() >= 0) return clocks;
    }
    return clocks + NoMore;
  }
};

}  // namespace racebeam
