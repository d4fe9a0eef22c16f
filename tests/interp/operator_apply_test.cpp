#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "delaunay/error.hpp"
#include "interp/nearest_surface.hpp"
#include "interp/operator.hpp"
#include "interp/operator_assembly.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using delaunay::Node;
using delaunay::Site;
using support::at_lonlat;
using support::first_difference;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

RunOptions threads(int count) { return {.num_threads = count, .progress = {}}; }

// Rows of 0 to 60 weights, of both signs, that sum to one.
Operator long_rows(std::int64_t num_targets, int num_rows) {
  Operator::Matrix matrix(num_targets, num_rows);
  support::SplitMix64 random(1);
  for (int i = 0; i < num_targets; ++i) {
    matrix.startVec(i);
    const int size = i % 61, first = (7 * i) % (num_rows - 61);
    double sum = 0;
    for (int k = 0; k < size; ++k) {
      const double weight = k + 1 == size ? 1 - sum : random.between(-0.5, 0.5);
      matrix.insertBack(i, first + k) = weight;
      sum += weight;
    }
  }
  matrix.finalize();
  return Operator(matrix.markAsRValue());
}

Fields side_by_side(const std::vector<std::vector<double>>& fields) {
  Fields result(std::ssize(fields[0]), std::ssize(fields));
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::size_t i = 0; i < fields[f].size(); ++i)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(f)) = fields[f][i];
  return result;
}

std::vector<double> column(const Fields& fields, Eigen::Index f) {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < fields.rows(); ++i) result.push_back(fields(i, f));
  return result;
}

TEST(Operator, AppliedIsTheProductWithTheMatrix) {
  const Operator op = long_rows(9000, 500);
  const std::vector<double> values = random_values(500, 2);
  const Eigen::VectorXd product =
      op.matrix() * Eigen::Map<const Eigen::VectorXd>(values.data(), 500);
  const std::vector<double> applied = op.apply(values);
  for (Eigen::Index i = 0; i < product.size(); ++i) {
    if (i % 61 == 0) {
      EXPECT_TRUE(std::isnan(applied[at(i)]));
    } else {
      EXPECT_NEAR(applied[at(i)], product[i], 1e-13);
    }
  }
}

TEST(Operator, ManyFieldsAtOnceAreTheBitsOfEachAlone) {
  const Operator op = long_rows(5000, 500);
  for (const std::size_t count : {1, 2, 3, 5, 8, 11, 16, 23}) {
    std::vector<std::vector<double>> fields;
    for (std::size_t f = 0; f < count; ++f) fields.push_back(random_values(500, f));
    fields[count / 2][77] = nan;
    for (const MissingRows policy : {MissingRows::propagate, MissingRows::renormalise}) {
      const Fields all = op.apply_fields(side_by_side(fields), {.missing = policy});
      ASSERT_EQ(all.cols(), std::ssize(fields));
      for (std::size_t f = 0; f < count; ++f) {
        EXPECT_EQ(first_difference(column(all, static_cast<Eigen::Index>(f)),
                                   op.apply(fields[f], {.missing = policy})),
                  5000u);
      }
    }
  }
  EXPECT_EQ(op.apply_fields(Fields(500, 0)).cols(), 0);
}

TEST(Operator, ResultsAreTheSameBitsForEveryNumberOfThreads) {
  const Operator op = long_rows(40000, 500);
  const std::vector<double> values = random_values(500, 2),
                            back = random_values(40000, 3);
  EXPECT_EQ(first_difference(op.apply(values, {}, threads(1)),
                             op.apply(values, {}, threads(5))),
            40000u);
  EXPECT_EQ(op.transposed().apply(back, threads(1)),
            op.transposed().apply(back, threads(5)));
  const Fields fields = side_by_side({values, values, values});
  EXPECT_EQ(first_difference(column(op.apply_fields(fields, {}, threads(1)), 2),
                             column(op.apply_fields(fields, {}, threads(5)), 2)),
            40000u);
}

TEST(Operator, AssembledIsTheSameForEveryNumberOfThreads) {
  const PlanePoints points = support::uniform_points(1000, 1);
  const auto t = triangulated(points);
  const PlanePoints targets = support::uniform_points(30000, 2);
  const Operator one = linear_operator(t, targets, {}, threads(1)),
                 five = linear_operator(t, targets, {}, threads(5));
  ASSERT_EQ(one.matrix().nonZeros(), five.matrix().nonZeros());
  for (Eigen::Index k = 0; k < one.matrix().nonZeros(); ++k) {
    ASSERT_EQ(one.matrix().valuePtr()[k], five.matrix().valuePtr()[k]);
    ASSERT_EQ(one.matrix().innerIndexPtr()[k], five.matrix().innerIndexPtr()[k]);
  }
}

TEST(Operator, TransposedIsTheAdjoint) {
  const Operator op = long_rows(3000, 400);
  const std::vector<double> x = random_values(400, 1);
  std::vector<double> y = random_values(3000, 2);
  const std::vector<double> forward = op.apply(x), back = op.apply_transposed(y);
  double left = 0, right = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (!std::isnan(forward[i])) left += y[i] * forward[i];
  for (std::size_t i = 0; i < x.size(); ++i) right += x[i] * back[i];
  EXPECT_NEAR(left, right, 1e-11);
  y[0] = nan;  // a missing target
  EXPECT_EQ(op.apply_transposed(y), back);
  EXPECT_EQ(op.transposed().apply(y), back);
}

// Half of row 0, a quarter of rows 1 and 2.
Operator three_weights() {
  Operator::Matrix matrix(1, 3);
  matrix.startVec(0);
  matrix.insertBack(0, 0) = 0.5;
  matrix.insertBack(0, 1) = 0.25;
  matrix.insertBack(0, 2) = 0.25;
  matrix.finalize();
  return Operator(matrix.markAsRValue());
}

TEST(Operator, MissingRowsPropagateUnlessRenormalised) {
  const Operator op = three_weights();
  const ApplyOptions half{.missing = MissingRows::renormalise},
      most{.missing = MissingRows::renormalise, .least_share = 0.75};
  EXPECT_TRUE(std::isnan(op.apply(std::vector<double>{1, 2, nan})[0]));
  EXPECT_DOUBLE_EQ(op.apply(std::vector<double>{1, 4, nan}, half)[0], 2);
  EXPECT_DOUBLE_EQ(op.apply(std::vector<double>{1, nan, nan}, half)[0], 1);
  EXPECT_TRUE(std::isnan(op.apply(std::vector<double>{1, nan, nan}, most)[0]));
  EXPECT_DOUBLE_EQ(op.apply(std::vector<double>{nan, 3, 3}, half)[0], 3);
  EXPECT_TRUE(std::isnan(op.apply(std::vector<double>{nan, 3, nan}, half)[0]));
  EXPECT_TRUE(std::isnan(op.apply(std::vector<double>{nan, nan, nan}, half)[0]));
}

TEST(Operator, RenormalisingKeepsConstantsAndFieldsWithoutGaps) {
  const Operator op = long_rows(2000, 400);
  std::vector<double> values = random_values(400, 4);
  const ApplyOptions renormalise{.missing = MissingRows::renormalise};
  EXPECT_EQ(first_difference(op.apply(values), op.apply(values, renormalise)), 2000u);
  std::fill(values.begin(), values.end(), 3.0);
  for (std::size_t i = 0; i < values.size(); i += 5) values[i] = nan;
  for (const double v : op.apply(values, renormalise)) {
    if (!std::isnan(v)) {
      EXPECT_NEAR(v, 3, 1e-10);
    }
  }
}

TEST(Operator, RefusesSharesAndSizesOutOfRange) {
  const Operator op = three_weights();
  const std::vector<double> values{1, 2, 3};
  for (const double share : {0.0, -1.0, 1.5, nan})
    EXPECT_THROW((void)op.apply(values, {.least_share = share}), Error);
  EXPECT_THROW((void)op.apply(std::vector<double>{1, 2}), Error);
  EXPECT_THROW((void)op.apply_fields(Fields(2, 2)), Error);
  EXPECT_THROW((void)op.apply_transposed(values), Error);
  EXPECT_THROW((void)op.transposed().apply(values), Error);
}

TEST(Operator, PropagatesVariances) {
  const Operator op = three_weights();
  EXPECT_DOUBLE_EQ(op.propagated_variance(std::vector<double>{4, 16, 0})[0], 2);
  EXPECT_DOUBLE_EQ(op.propagated_deviation(std::vector<double>{2, 4, 0})[0],
                   std::sqrt(2.0));
  for (const double bad : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
    try {
      (void)op.propagated_variance(std::vector<double>{1, 1, bad});
      FAIL() << bad;
    } catch (const Error& error) {
      EXPECT_EQ(error.rows().front(), 2);
    }
    EXPECT_THROW((void)op.propagated_deviation(std::vector<double>{bad, 1, 1}), Error);
  }
  EXPECT_THROW((void)op.propagated_variance(std::vector<double>{1}), Error);
}

TEST(Operator, VarianceIsThatOfRandomErrors) {
  const PlanePoints points = support::uniform_points(50, 1), target{{0.5, 0.5}};
  const Operator op = linear_operator(triangulated(points), target);
  double sum = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double v = op.apply(random_values(50, static_cast<std::uint64_t>(i)))[0];
    sum += v * v;
  }
  const double expected = op.propagated_variance(std::vector<double>(50, 1.0 / 3))[0];
  EXPECT_NEAR(sum / count, expected, 0.04 * expected);
}

TEST(Operator, OverTheRemainingRowsAppliesToWholeFields) {
  PlanePoints points = support::uniform_points(100, 3);
  std::vector<double> values = random_values(100, 4);
  const PlanePoints targets = support::uniform_points(200, 5);
  PlanePoints remaining;
  std::vector<Node> rows;
  std::vector<double> kept;
  for (Node i = 0; i < 100; ++i) {
    if (i % 7 == 0) {
      values[at(i)] = nan;
      continue;
    }
    rows.push_back(i);
    remaining.push_back(points[at(i)]);
    kept.push_back(values[at(i)]);
  }
  const Operator op = linear_operator(triangulated(remaining), targets);
  EXPECT_EQ(first_difference(op.spread_to_rows(rows, 100).apply(values), op.apply(kept)),
            targets.size());
  EXPECT_THROW((void)op.spread_to_rows(rows, 50), Error);
  std::swap(rows[0], rows[1]);
  EXPECT_THROW((void)op.spread_to_rows(rows, 100), Error);
}

TEST(NearestOperator, AppliedIsTheSurfaceBitForBit) {
  const PlanePoints points = support::uniform_points(200, 1),
                    targets = support::uniform_points(900, 2);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(200, 3);
  for (const SurfaceOptions& options :
       {SurfaceOptions{}, SurfaceOptions{.outside = Outside::nearest},
        SurfaceOptions{.outside = Outside::nearest, .max_distance = 0.03}}) {
    EXPECT_EQ(first_difference(nearest_operator(t, targets, options).apply(values),
                               PlaneNearest(t, values, options).values(targets)),
              targets.size());
  }
  EXPECT_THROW((void)nearest_operator(t, targets, {.outside = Outside::linear}), Error);
}

TEST(NearestOperator, OnTheSphereIsTheSurfaceBitForBit) {
  SpherePoints points, targets;
  for (const tripack::Point2 p : support::uniform_points(300, 1))
    points.push_back(at_lonlat(360 * p.x, 160 * p.y - 80));
  for (const tripack::Point2 p : support::uniform_points(900, 2))
    targets.push_back(at_lonlat(360 * p.x, 180 * p.y - 90));
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(300, 3);
  EXPECT_EQ(first_difference(nearest_operator(t, targets).apply(values),
                             SphereNearest(t, values).values(targets)),
            targets.size());
}

TEST(AssembleOperator, TakesLongRowsWithRepeatedSitesAndRows) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}};
  const tripack::Triangulation t(points);
  const RowShares shares(t, Duplicates::mean);
  const PlanePoints targets{{0.1, 0.1}, {0.2, 0.9}};
  const Site origin = t.sites()[0], other = t.sites()[3];
  const Operator op =
      assemble_operator<tripack::Point2>(targets, t.adjacency(), shares, t.num_rows(),
                                         threads(1), [&](tripack::Point2 p, Cursor&) {
                                           TermList terms;
                                           if (p.y > 0.5) return terms;
                                           for (int k = 0; k < 20; ++k)
                                             terms.add(k % 2 == 0 ? other : origin, 0.05);
                                           return terms;
                                         });
  EXPECT_EQ(op.matrix().nonZeros(), 3);
  EXPECT_NEAR(op.matrix().coeff(0, 0), 0.25, 1e-15);
  EXPECT_NEAR(op.matrix().coeff(0, 4), 0.25, 1e-15);
  EXPECT_NEAR(op.matrix().coeff(0, 3), 0.5, 1e-15);
  EXPECT_TRUE(std::isnan(op.apply(std::vector<double>(5, 1.0))[1]));
}

TEST(AssembleOperator, OfNoTargetsIsEmpty) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}});
  const Operator op = linear_operator(t, PlanePoints{});
  EXPECT_EQ(op.matrix().rows(), 0);
  EXPECT_TRUE(op.apply(std::vector<double>{1, 2, 3}).empty());
  EXPECT_EQ(op.apply_transposed({}), std::vector<double>(3, 0.0));
}

TEST(AssembleOperator, CanBeCancelled) {
  const auto t = triangulated(support::uniform_points(100, 1));
  const PlanePoints targets = support::uniform_points(20000, 2);
  EXPECT_THROW(
      (void)linear_operator(t, targets, {},
                            {.num_threads = 1, .progress = [](double) { return false; }}),
      Cancelled);
}

TEST(TermList, SumsFromTheFirstSite) {
  TermList terms;
  EXPECT_TRUE(std::isnan(weighted_value(terms, std::vector<double>{})));
  for (int k = 0; k < 100; ++k) terms.add(k % 3, 0.01);
  EXPECT_EQ(weighted_value(terms, std::vector<double>{0.1, 0.1, 0.1}), 0.1);
}

}  // namespace
}  // namespace delone::interp
