#include "interp/smooth_operator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "delaunay/error.hpp"
#include "interp/c1_choices.hpp"
#include "interp/factored_checks.hpp"
#include "interp/smooth_surface.hpp"

namespace delone::interp {
namespace {

using support::expect_equal_values;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

template <class Triangulation>
SmoothOptions smoothing(const Triangulation& t, double wavelength) {
  SmoothOptions options;
  options.by = SmoothBy::wavelength;
  options.wavelength = wavelength;
  C1Options given;
  given.gradients = Gradients::given;
  options.choices = c1_choices(t, given);
  return options;
}

double extent_of(const tripack::Triangulation& t) {
  const Region r = support::region_of(t);
  const double extent = std::max(r.east - r.west, r.north - r.south);
  return extent > 0 ? extent : 1;
}

/// Gradients across sets that are nearly collinear are next to undetermined; so are they
/// where distances are of all scales, and harmonics on very small regions. On the tiniest
/// sets the surface has no gradients.
bool is_nearly_singular(const std::string& name) {
  return name == "collinear_almost" || name == "sum_to_one" || name == "one_far_away" ||
         name == "stretched" || name == "all_scales" || name == "tiniest" ||
         name == "ulps_apart" || name == "city" || name == "box_of_pico_radians";
}

/// Equal within 1e-13 of the range of the data, or of the surface's own where it leaves
/// that.
void expect_near(const std::vector<double>& applied, const std::vector<double>& direct) {
  ASSERT_EQ(applied.size(), direct.size());
  for (std::size_t i = 0; i < direct.size(); ++i) {
    ASSERT_EQ(std::isnan(applied[i]), std::isnan(direct[i])) << i;
    if (!std::isnan(direct[i])) {
      ASSERT_NEAR(applied[i], direct[i], std::max(2e-13, 1e-13 * std::abs(direct[i])));
    }
  }
}

/// Rows are exact or refused.
void expect_rows_agree_or_refused(const FactoredOperator& op) {
  try {
    support::expect_rows_agree(op, 5, 1e-6);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("without making its rows"),
              std::string::npos);
  }
}

class PlaneSmoothOperatorOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneSmoothOperatorOnSets, AppliedEqualsTheSurfaceWithTheSameChoices) {
  const PlanePoints points = GetParam().make(40, 1);
  const auto t = triangulated(points);
  PlanePoints targets = support::points_of_the_hull(*t, 2);
  const std::vector<double> values = random_values(points.size(), 3);
  for (const double part : {0.0, 0.2, 2.0, std::numeric_limits<double>::infinity()}) {
    const SmoothOptions options = smoothing(*t, part == 0 ? 0 : part * extent_of(*t));
    const FactoredOperator op = smooth_operator(t, targets, options);
    const std::vector<double> applied = op.apply(values),
                              direct = PlaneSmooth(t, values, options).values(targets);
    if (is_nearly_singular(std::string(GetParam().name))) {
      for (std::size_t i = 0; i < direct.size(); ++i)
        ASSERT_EQ(std::isnan(applied[i]), std::isnan(direct[i])) << i;
      expect_rows_agree_or_refused(op);
      continue;
    }
    expect_near(applied, direct);
    support::expect_rows_agree(op, 5, 1e-11);
    support::expect_transpose_is_adjoint(op, 7);
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneSmoothOperatorOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

class SphereSmoothOperatorOnSets : public testing::TestWithParam<support::SphereFamily> {
};

TEST_P(SphereSmoothOperatorOnSets, AppliedEqualsTheSurfaceWithTheSameChoices) {
  const SpherePoints points = GetParam().make(40, 1);
  const auto t = triangulated(points);
  SpherePoints targets = globe_nodes(globe_grid({-180, 180, -90, 90}, Spacing{45, 45}));
  targets.insert(targets.end(), t->points().begin(), t->points().end());
  const std::vector<double> values = random_values(points.size(), 3);
  for (const double wavelength : {0.0, 0.5, std::numeric_limits<double>::infinity()}) {
    const SmoothOptions options = smoothing(*t, wavelength);
    const FactoredOperator op = smooth_operator(t, targets, options);
    const std::vector<double> applied = op.apply(values),
                              direct = SphereSmooth(t, values, options).values(targets);
    if (is_nearly_singular(std::string(GetParam().name))) {
      for (std::size_t i = 0; i < direct.size(); ++i)
        ASSERT_EQ(std::isnan(applied[i]), std::isnan(direct[i])) << i;
      expect_rows_agree_or_refused(op);
      continue;
    }
    expect_near(applied, direct);
    support::expect_rows_agree(op, 5, 1e-11);
    support::expect_transpose_is_adjoint(op, 7);
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereSmoothOperatorOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(SmoothOperator, HasWhatFactoredOperatorsHave) {
  const auto t = triangulated(support::uniform_points(150, 1));
  const FactoredOperator op =
      smooth_operator(t, support::uniform_points(100, 2), smoothing(*t, 0.3));
  support::expect_common_behaviour(op);
  support::expect_variances_of_rows(op);
  const auto globe = triangulated(support::uniform_directions(100, 1));
  support::expect_common_behaviour(smooth_operator(
      globe, support::uniform_directions(100, 2), smoothing(*globe, 0.8)));
}

TEST(SmoothOperator, NoValueIsChangedByMoreThanTheTolerance) {
  const auto t = triangulated(support::uniform_points(300, 1));
  const FactoredOperator op =
      smooth_operator(t, support::uniform_points(20, 2), smoothing(*t, 0.1));
  double before = 1;
  for (const double tolerance : {1e-9, 1e-6, 1e-3}) {
    const double left = support::part_left_by(op, tolerance);
    EXPECT_LT(left, before);
    before = left;
  }
}

TEST(SmoothOperator, ErrorsAndRepeatedRowsCountAsInTheSurface) {
  PlanePoints points = support::uniform_points(60, 1);
  points.push_back(points[5]);
  points.push_back(points[5]);
  std::vector<double> errors;
  for (std::size_t i = 0; i < points.size(); ++i)
    errors.push_back(0.1 + 0.05 * static_cast<double>(i % 7));
  const std::vector<double> values = random_values(points.size(), 2);
  const auto t = triangulated(points);
  const PlanePoints targets = support::uniform_points(50, 3);
  for (const Duplicates policy :
       {Duplicates::mean, Duplicates::first, Duplicates::last}) {
    SmoothOptions options = smoothing(*t, 0.3);
    options.errors = errors;
    options.duplicates = policy;
    expect_equal_values(smooth_operator(t, targets, options).apply(values),
                        PlaneSmooth(t, values, options).values(targets));
  }
}

TEST(SmoothOperator, DampsNoiseAsTheTraceSays) {
  const PlanePoints points = support::uniform_points(200, 1);
  const auto t = triangulated(points);
  const SmoothOptions options = smoothing(*t, 0.4);
  const Operator rows = smooth_operator(t, points, options).explicit_rows();
  double trace = 0;
  for (int i = 0; i < 200; ++i) trace += rows.matrix().coeff(i, i);
  const PlaneSmooth surface(t, random_values(200, 2), options);
  EXPECT_NEAR(trace, surface.fit().degrees_of_freedom, 1e-6 * trace);
}

TEST(SmoothOperator, RefusesWhatIsNotLinear) {
  const auto t = triangulated(support::uniform_points(30, 1));
  const PlanePoints targets{{0.5, 0.5}};
  SmoothOptions options;
  EXPECT_THROW((void)smooth_operator(t, targets, options), Error);
  options.by = SmoothBy::errors;
  EXPECT_THROW((void)smooth_operator(t, targets, options), Error);
  options.by = SmoothBy::wavelength;
  options.wavelength = -1;
  EXPECT_THROW((void)smooth_operator(t, targets, options), Error);
  options.wavelength = 0.2;
  EXPECT_NO_THROW((void)smooth_operator(t, targets, options));
  options.choices = c1_choices(*t);  // for local gradients
  EXPECT_THROW((void)smooth_operator(t, targets, options), Error);
  EXPECT_THROW((void)PlaneSmooth(t, random_values(30, 1), options), Error);
  const std::vector<double> errors(29, 1.0);
  options = smoothing(*t, 0.2);
  options.errors = errors;
  EXPECT_THROW((void)smooth_operator(t, targets, options), Error);
}

TEST(SmoothOperator, OfFewPointsGivesTheSurface) {
  const PlanePoints targets{{0.25, 0.25}, {0, 0}, {3, 3}, {0.5, 0}};
  for (const PlanePoints& points :
       {PlanePoints{}, PlanePoints{{0, 0}}, PlanePoints{{0, 0}, {0.5, 0.5}},
        PlanePoints{{0, 0}, {1, 0}, {0, 1}},
        PlanePoints{{0, 0}, {0.25, 0}, {0.6, 0}, {1, 0}}}) {
    const auto t = triangulated(points);
    const std::vector<double> values = random_values(points.size(), 1);
    const SmoothOptions options = smoothing(*t, 0.7);
    expect_equal_values(smooth_operator(t, targets, options).apply(values),
                        PlaneSmooth(t, values, options).values(targets));
  }
}

}  // namespace
}  // namespace delone::interp
