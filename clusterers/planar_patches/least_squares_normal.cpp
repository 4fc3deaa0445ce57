// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "least_squares_normal.h"

namespace gestalt {

namespace {

constexpr float edge_on = 1e-4f;  // cosine of ray and normal below which a camera sees no surface, only noise
constexpr float line = 1e-6f;     // how much longer the second axis is than the first, below which it is rounding

template <class F>
GESTALT_INLINE void find(const NeighbourMoments<F>& m, const Vector<F>& point, LeastSquaresNormal<F>& normal) {
  const F zero{}, one = zero + 1, third = one / 3;

  // The covariance, scaled to a trace of 1: float32 then has room for the cubes of the closed form.
  const F i = one / m.n;
  F xx = m.xx - m.x * m.x * i, yy = m.yy - m.y * m.y * i, ww = m.ww - m.w * m.w * i;
  F xy = m.xy - m.x * m.y * i, xw = m.xw - m.x * m.w * i, yw = m.yw - m.y * m.w * i;
  const F trace = xx + yy + ww, scale = one / trace;
  xx *= scale, yy *= scale, ww *= scale, xy *= scale, xw *= scale, yw *= scale;

  // Its smallest eigenvalue is third + 2 spread x, x the smallest root of 4 x^3 - 3 x = r. The root is in [-1, -1/2]; a
  // guess that is exact at both ends takes three of Newton's steps to the precision of float32.
  F a = xx - third, b = yy - third, c = ww - third;
  const F squared_spread = (a * a + b * b + c * c + 2 * (xy * xy + xw * xw + yw * yw)) / 6;
  F spread = squared_spread;
  take_root(spread);
  const F determinant = a * (b * c - yw * yw) - xy * (xy * c - yw * xw) + xw * (xy * yw - b * xw);
  F r = determinant / (2 * spread * squared_spread);
  r = r < -one ? -one : r;
  r = r > one ? one : r;
  F guess = (one - r) / 2;
  take_root(guess);
  F x = (guess + 1) / -2;
  for (int step = 0; step < 3; ++step) {
    const F slope = 12 * x * x - 3;
    x -= slope > zero ? ((4 * x * x - 3) * x - r) / slope : zero;
  }
  const F value = third + 2 * spread * x;

  // Its vector is the longest cross product of two rows of what is left.
  a = xx - value, b = yy - value, c = ww - value;
  F nx = xy * yw - xw * b, ny = xw * xy - a * yw, nz = a * b - xy * xy, longest = nx * nx + ny * ny + nz * nz;
  const auto longer = [&](const F& ox, const F& oy, const F& oz) {
    const F length = ox * ox + oy * oy + oz * oz;
    nx = length > longest ? ox : nx;
    ny = length > longest ? oy : ny;
    nz = length > longest ? oz : nz;
    longest = length > longest ? length : longest;
  };
  longer(xy * c - xw * yw, xw * xw - a * c, a * yw - xy * xw);
  longer(b * c - yw * yw, yw * xw - xy * c, xy * yw - b * xw);

  const F along = nx * point.x + ny * point.y + nz * point.z;
  const F squared_ray = point.x * point.x + point.y * point.y + point.z * point.z;
  F length = longest;
  take_root(length);
  const F to_camera = (along > zero ? -one : one) / length;
  // What is not a number, as where the moments are all 0, fails each comparison.
  F found = m.n >= 3 ? one : zero;
  found = trace > zero ? found : zero;
  found = squared_spread > zero ? found : zero;
  found = longest > zero + line * line ? found : zero;
  found = along * along >= edge_on * edge_on * squared_ray * longest ? found : zero;
  normal.x = found > zero ? to_camera * nx : zero;
  normal.y = found > zero ? to_camera * ny : zero;
  normal.z = found > zero ? to_camera * nz : zero;
  const F not_negative = value < zero ? zero : value, curvature = not_negative > third ? third : not_negative;
  normal.curvature = found > zero ? curvature : one;
}

}  // namespace

void find_normal(const NeighbourMoments<float>& moments, const Vector<float>& point,
                 LeastSquaresNormal<float>& normal) {
  find(moments, point, normal);
}

GESTALT_WIDE void find_normal(const NeighbourMoments<WideFloats>& moments, const Vector<WideFloats>& point,
                              LeastSquaresNormal<WideFloats>& normal) {
  find(moments, point, normal);
}

}  // namespace gestalt
