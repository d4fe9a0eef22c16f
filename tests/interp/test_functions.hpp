#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "support/plane_sets.hpp"

/// The functions and node sets that interpolants are compared on: R. J. Renka, R. Brown,
/// ACM Trans. Math. Softw. 25 (1999) 78-94 (Algorithm 792).
namespace delone::support {

inline double square(double a) { return a * a; }

inline double franke(tripack::Point2 p) {
  const double x = 9 * p.x, y = 9 * p.y;
  return 0.75 * std::exp(-(square(x - 2) + square(y - 2)) / 4) +
         0.75 * std::exp(-square(x + 1) / 49 - (y + 1) / 10) +
         0.5 * std::exp(-(square(x - 7) + square(y - 3)) / 4) -
         0.2 * std::exp(-square(x - 4) - square(y - 7));
}
inline double cliff(tripack::Point2 p) { return (std::tanh(9 * (p.y - p.x)) + 1) / 9; }
inline double saddle(tripack::Point2 p) {
  return (1.25 + std::cos(5.4 * p.y)) / (6 + 6 * square(3 * p.x - 1));
}
inline double squared_from_middle(tripack::Point2 p) {
  return square(p.x - 0.5) + square(p.y - 0.5);
}
inline double gentle(tripack::Point2 p) {
  return std::exp(-81.0 / 16 * squared_from_middle(p)) / 3;
}
inline double steep(tripack::Point2 p) {
  return std::exp(-81.0 / 4 * squared_from_middle(p)) / 3;
}
inline double ball(tripack::Point2 p) {
  const double squared = 64 - 81 * squared_from_middle(p);
  return squared > 0 ? std::sqrt(squared) / 9 - 0.5 : 0;
}
inline double trigonometric(tripack::Point2 p) {
  return 2 * std::cos(10 * p.x) * std::sin(10 * p.y) + std::sin(10 * p.x * p.y);
}
inline double ridges(tripack::Point2 p) {
  const double a = std::exp(-square(5 - 10 * p.x) / 2),
               b = std::exp(-square(5 - 10 * p.y) / 2);
  return a + 0.75 * b * (1 + a);
}
inline double cloverleaf(tripack::Point2 point) {
  const double p = std::exp((10 - 20 * point.x) / 3),
               q = std::exp((10 - 20 * point.y) / 3);
  const double s = 1 / (1 + p), t = 1 / (1 + q);
  return square(std::pow(20.0 / 3, 3) * p * q) * std::pow(s * t, 5) * (p - 2 * s) *
         (q - 2 * t);
}
inline double cosine_peak(tripack::Point2 p) {
  const double u = std::sqrt(square(80 * p.x - 40) + square(90 * p.y - 45));
  return std::exp(-0.04 * u) * std::cos(0.15 * u);
}

using PlaneFunction = double (*)(tripack::Point2);
inline constexpr std::array<PlaneFunction, 10> renka_brown_functions{
    franke, cliff,         saddle, gentle,     steep,
    ball,   trigonometric, ridges, cloverleaf, cosine_peak};

/// Node set 2: 33 nodes, after Franke.
inline PlanePoints renka_brown_set_2() {
  return {{.05, .45}, {0, .5},    {0, 1},     {0, 0},    {.1, .15},  {.1, .75},
          {.15, .3},  {.2, .1},   {.25, .2},  {.3, .35}, {.35, .85}, {.5, 0},
          {.5, 1},    {.55, .95}, {.6, .25},  {.6, .65}, {.6, .85},  {.65, .7},
          {.7, .2},   {.7, .65},  {.7, .9},   {.75, .1}, {.75, .35}, {.75, .85},
          {.8, .4},   {.8, .65},  {.85, .25}, {.9, .35}, {.9, .8},   {.95, .9},
          {1, 0},     {1, .5},    {1, 1}};
}
/// Node set 3: 25 nodes, after Lawson.
inline PlanePoints renka_brown_set_3() {
  return {{.1375, .975}, {.9125, .9875}, {.7125, .7625}, {.225, .8375},   {-.05, .4125},
          {.475, .6375}, {.05, -.05},    {.45, 1.0375},  {1.0875, .55},   {.5375, .8},
          {-.0375, .75}, {.1875, .575},  {.7125, .55},   {.85, .4375},    {.7, .3125},
          {.275, .425},  {.45, .2875},   {.8125, .1875}, {.45, -.0375},   {1, .2625},
          {.5, .4625},   {.1875, .2625}, {.5875, .125},  {1.05, -.06125}, {.1, .1125}};
}
/// Node set 5: nine by nine.
inline PlanePoints renka_brown_set_5() {
  PlanePoints points;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) points.push_back({i / 8.0, j / 8.0});
  }
  return points;
}

/// What they measure: the sum of squared errors on 33 x 33 nodes of the unit square over
/// the sum of squared deviations of the function from its mean there.
template <class Surface>
double relative_squared_error(const Surface& surface, PlaneFunction f) {
  PlanePoints nodes;
  double mean = 0;
  for (int i = 0; i <= 32; ++i) {
    for (int j = 0; j <= 32; ++j) {
      nodes.push_back({i / 32.0, j / 32.0});
      mean += f(nodes.back()) / 1089;
    }
  }
  double errors = 0, deviations = 0;
  for (const tripack::Point2 p : nodes) {
    errors += square(surface.value(p) - f(p));
    deviations += square(f(p) - mean);
  }
  return errors / deviations;
}

}  // namespace delone::support
