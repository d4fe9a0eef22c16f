#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "interp/index.hpp"
#include "interp/leave_one_out.hpp"
#include "interp/surfaces.hpp"

/// Judges of leave-one-out predictions.
namespace delone::support {

/// The rows that are at other positions, and their values.
template <class Triangulation, class Points>
std::pair<Points, std::vector<double>> without(const Triangulation& t,
                                               const Points& points,
                                               std::span<const double> values,
                                               delaunay::Site site) {
  std::pair<Points, std::vector<double>> rest;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (t.sites()[row] == site) continue;
    rest.first.push_back(points[row]);
    rest.second.push_back(values[row]);
  }
  return rest;
}

/// Predictions are those of `make(triangulation, values)` over a triangulation built
/// without the position, at some eight sites spread over all.
template <class Triangulation, class Points, class Make>
void expect_as_rebuilt(const Triangulation& t, const Points& points,
                       const std::vector<double>& values,
                       const interp::LeaveOneOut& found, double error, Make make) {
  constexpr delaunay::Site most = 8;
  const delaunay::Site step = std::max(1, t.num_sites() / most);
  for (delaunay::Site s = 0; s < t.num_sites(); s += step) {
    const auto others = without(t, points, values, s);
    const double wanted =
        make(triangulated(others.first), others.second).value(t.points()[interp::at(s)]);
    const double predicted = found.predicted[interp::at(t.rows()[interp::at(s)])];
    ASSERT_EQ(std::isnan(predicted), std::isnan(wanted)) << "site " << s;
    if (!std::isnan(wanted)) {
      ASSERT_NEAR(predicted, wanted, error) << "site " << s;
    }
  }
}

}  // namespace delone::support
