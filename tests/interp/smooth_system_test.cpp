// The equations of smoothing surfaces, against integrals and dense matrices.

#include "interp/smooth_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "interp/smooth_factor.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A square lattice whose inner nodes are moved a little.
support::PlanePoints shaken_lattice(std::size_t width) {
  support::SplitMix64 random(5);
  support::PlanePoints points = support::lattice_points(width * width);
  const auto last = static_cast<double>(width - 1);
  for (tripack::Point2& p : points) {
    if (p.x == 0 || p.y == 0 || p.x == last || p.y == last) continue;
    p.x += random.between(-0.2, 0.2);
    p.y += random.between(-0.2, 0.2);
  }
  return points;
}

VectorXd unknowns_of(const SmoothSystem& system, double xx, double xy, double yy) {
  VectorXd x(3 * Index{system.num_sites()});
  for (Index s = 0; s < system.num_sites(); ++s) {
    const auto& p = system.places[static_cast<std::size_t>(s)];
    x.segment<3>(3 * s) << 0.5 * xx * p[0] * p[0] + xy * p[0] * p[1] +
                               0.5 * yy * p[1] * p[1] + 3 * p[0] - 2 * p[1] + 7,
        xx * p[0] + xy * p[1] + 3, xy * p[0] + yy * p[1] - 2;
  }
  return x;
}

double roughness(const SmoothSystem& system, const VectorXd& x) {
  VectorXd forces = system.apply(1, x);
  for (Index s = 0; s < system.num_sites(); ++s)
    forces[3 * s] -= system.weights[s] * x[3 * s];
  return x.dot(forces);
}

MatrixXd dense(const SmoothSystem& system, double parameter) {
  const Index size = 3 * Index{system.num_sites()};
  MatrixXd matrix(size, size);
  for (Index k = 0; k < size; ++k)
    matrix.col(k) = system.apply(parameter, VectorXd::Unit(size, k));
  return matrix;
}

TEST(SmoothSystem, RoughnessOfQuadraticFunctionsIsTheIntegralOfSquaredSecondDerivatives) {
  const support::PlanePoints points = shaken_lattice(12);
  const tripack::Triangulation t(points);
  const SmoothSystem system =
      smooth_system<PlaneSpace>(t, std::vector<double>(points.size(), 1.0));
  EXPECT_NEAR(system.area, 121 * system.scale * system.scale, 1e-12);
  for (const auto& [xx, xy, yy] : {std::array{1.0, 0.0, 0.0}, std::array{0.0, 0.0, 2.0},
                                   std::array{0.0, 1.0, 0.0}, std::array{2.0, -1.5, 0.3}})
    EXPECT_NEAR(roughness(system, unknowns_of(system, xx, xy, yy)),
                system.area * (xx * xx + 2 * xy * xy + yy * yy), 1e-9);
}

TEST(SmoothSystem, LinearFunctionsCostNothing) {
  const support::PlanePoints points = support::uniform_points(100, 3);
  const tripack::Triangulation t(points);
  const SmoothSystem system =
      smooth_system<PlaneSpace>(t, std::vector<double>(points.size(), 1.0));
  EXPECT_NEAR(roughness(system, unknowns_of(system, 0, 0, 0)), 0, 1e-9);
  for (Index k = 0; k < 2; ++k)
    EXPECT_NEAR(roughness(system, system.trend.col(k)), 0, 1e-12);
}

template <class Space, class Points>
void expect_dense_solution(const Points& points) {
  const auto t = support::triangulated(points);
  support::SplitMix64 random(8);
  std::vector<double> weights(static_cast<std::size_t>(t->num_sites()));
  for (double& w : weights) w = random.between(0.5, 2);
  const SmoothSystem system = smooth_system<Space>(*t, weights);
  const double parameter = system.parameter(0.3);
  const std::vector<EliminationFront> fronts = dissect(system);
  const SmoothFactor factor(system, fronts, parameter, {});
  const MatrixXd matrix = dense(system, parameter);
  const Eigen::LLT<MatrixXd> judge(matrix);
  ASSERT_EQ(judge.info(), Eigen::Success);
  VectorXd right(matrix.rows());
  for (double& r : right) r = random.between(-1, 1);
  const VectorXd expected = judge.solve(right);
  EXPECT_LT((factor.refined(right) - expected).norm(), 1e-8 * expected.norm());
  EXPECT_LT((factor.solve(right) - expected).norm(), 1e-6 * expected.norm());
  const MatrixXd inverse = judge.solve(MatrixXd::Identity(matrix.rows(), matrix.rows()));
  const VectorXd diagonal = factor.inverse_diagonal();
  for (Index s = 0; s < system.num_sites(); ++s)
    EXPECT_NEAR(diagonal[s], inverse(3 * s, 3 * s), 1e-7 * inverse(3 * s, 3 * s));
}

TEST(SmoothFactor, SolvesAndInvertsAsADenseFactorDoes) {
  expect_dense_solution<PlaneSpace>(support::uniform_points(90, 2));
  expect_dense_solution<PlaneSpace>(support::wheel_points(70));
  expect_dense_solution<PlaneSpace>(support::clustered_points(60, 4));
  expect_dense_solution<SphereSpace>(support::uniform_directions(90, 2));
  expect_dense_solution<SphereSpace>(support::box_directions(60, 6, 1e-3));
}

TEST(SmoothFactor, EliminatesEverySiteOnceAndTouchesOnlyLaterOnes) {
  const support::PlanePoints points = support::uniform_points(700, 9);
  const tripack::Triangulation t(points);
  const SmoothSystem system =
      smooth_system<PlaneSpace>(t, std::vector<double>(points.size(), 1.0));
  const std::vector<EliminationFront> fronts = dissect(system);
  std::vector<int> turn(points.size(), -1);
  int next = 0;
  for (const EliminationFront& f : fronts) {
    for (std::int32_t i = 0; i < f.num_own; ++i) {
      int& mine = turn[static_cast<std::size_t>(f.sites[static_cast<std::size_t>(i)])];
      EXPECT_EQ(mine, -1);
      mine = next++;
    }
  }
  EXPECT_EQ(next, 700);
  for (const EliminationFront& f : fronts) {
    for (std::size_t i = 1; i < f.sites.size(); ++i)
      EXPECT_LT(turn[static_cast<std::size_t>(f.sites[i - 1])],
                turn[static_cast<std::size_t>(f.sites[i])]);
  }
}

TEST(SmoothFactor, GivesTheSameBitsOnAnyNumberOfThreads) {
  const support::PlanePoints points = support::uniform_points(900, 4);
  const tripack::Triangulation t(points);
  const SmoothSystem system =
      smooth_system<PlaneSpace>(t, std::vector<double>(points.size(), 1.0));
  const std::vector<EliminationFront> fronts = dissect(system);
  const VectorXd right = VectorXd::LinSpaced(2700, -1, 1);
  const SmoothFactor one(system, fronts, 0.01, {.num_threads = 1, .progress = {}}),
      four(system, fronts, 0.01, {.num_threads = 4, .progress = {}});
  EXPECT_EQ(one.refined(right), four.refined(right));
}

}  // namespace
}  // namespace delone::interp
