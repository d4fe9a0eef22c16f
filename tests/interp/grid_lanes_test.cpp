#include "interp/grid_lanes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "interp/blend_lanes.hpp"
#include "interp/c1_surface.hpp"
#include "interp/globe_table.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::random_values;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double v : values) bits.push_back(std::bit_cast<std::uint64_t>(v));
  return bits;
}

std::vector<std::uint64_t> rows_of(const NodeMask& mask, const NodeBlock& block) {
  return {mask.rows, mask.rows + (block.rows.end - block.rows.begin)};
}

// A triangle on the nodes 0 .. 15 by 0 .. 8 of a unit grid, its first corner a node.
struct PlaneCase {
  std::vector<double> x, y;
  PlaneSides sides;
  PlainPlaneFacet facet;
  NodeBlock block{{1, 12}, {1, 8}};

  PlaneCase() {
    for (int i = 0; i < 16; ++i) x.push_back(i);
    x = padded(x.data(), 16);
    for (int j = 0; j < 9; ++j) y.push_back(j);
    const double px[3] = {2, 11.4, 4.3}, py[3] = {1, 2.7, 7.9};
    for (std::size_t k = 0; k < 3; ++k) {
      sides.x[k] = px[k], sides.y[k] = py[k];
      sides.dx[k] = px[(k + 1) % 3] - px[k], sides.dy[k] = py[(k + 1) % 3] - py[k];
    }
    sides.error = 0x1p-40;
    facet = {{2, 1}, 0.3, 0.7, -0.2, -1, 4.5};
  }
  [[nodiscard]] double side(std::size_t k, double px, double py) const {
    return sides.dx[k] * (py - sides.y[k]) - sides.dy[k] * (px - sides.x[k]);
  }
  [[nodiscard]] double least_side(std::int64_t i, std::int64_t j) const {
    const double px = x[at(i)], py = y[at(j)];
    return std::min(std::min(side(0, px, py), side(1, px, py)), side(2, px, py));
  }
};

TEST(GridLanes, OfEveryInstructionSetFillTheNodesInsideAPlanarTriangle) {
  const PlaneCase c;
  std::vector<double> expected(16 * 9, missing);
  for (std::int64_t j = c.block.rows.begin; j < c.block.rows.end; ++j) {
    for (std::int64_t i = c.block.columns.begin; i < c.block.columns.end; ++i) {
      if (!(c.least_side(i, j) > c.sides.error)) continue;
      const double start = 0.3 + -0.2 * (static_cast<double>(j) - 1);
      expected[at(j * 16 + i)] =
          std::max(-1.0, std::min(4.5, start + 0.7 * (static_cast<double>(i) - 2)));
    }
  }
  for (const GridKernels& kernels : grid_kernels()) {
    std::vector<double> out(16 * 9, missing);
    const NodeMask doubtful = kernels.fill_plane(
        c.sides, c.facet, {c.x.data(), c.y.data()}, c.block, {out.data(), 16});
    EXPECT_EQ(bits_of(out), bits_of(expected));
    // The corner that is a node, and two nodes on the edge of slope 3 that it begins.
    EXPECT_EQ(rows_of(doubtful, c.block),
              (std::vector<std::uint64_t>{2, 0, 0, 4, 0, 0, 8}));
  }
}

TEST(GridLanes, OfEveryInstructionSetCoverTheSameNodesOfAPlanarTriangle) {
  const PlaneCase c;
  for (const GridKernels& kernels : grid_kernels()) {
    const Cover cover = kernels.cover_plane(c.sides, {c.x.data(), c.y.data()}, c.block);
    for (std::int64_t j = c.block.rows.begin; j < c.block.rows.end; ++j) {
      for (std::int64_t i = c.block.columns.begin; i < c.block.columns.end; ++i) {
        const std::uint64_t row = cover.inside.rows[j - c.block.rows.begin];
        EXPECT_EQ((row >> (i - c.block.columns.begin) & 1) != 0,
                  c.least_side(i, j) > c.sides.error);
      }
    }
  }
}

TEST(GridLanes, OfEveryInstructionSetFillASphericalTriangleWithTheSameBits) {
  const GlobeTable table(globe_grid({-180, 180, -90, 90}, Spacing{2, 2}));
  const std::vector<double> cosines = padded(table.cos_lon(), table.columns()),
                            sines = padded(table.sin_lon(), table.columns());
  const GlobeAxes axes{cosines.data(), sines.data(), table.cos_lat(), table.sin_lat()};
  const Vector3 p[3] = {vector(Direction::from(stripack::LonLat{10.5, 20.25})),
                        vector(Direction::from(stripack::LonLat{31, 24})),
                        vector(Direction::from(stripack::LonLat{17, 51}))};
  SphereSides sides;
  for (std::size_t k = 0; k < 3; ++k)
    sides.normals[k] = cross(p[k], p[(k + 1) % 3] - p[k]);
  sides.error = 0x1p-47;
  const SphereFacet facet({p[0], 1.5}, {p[1], -0.25}, {p[2], 7});
  const NodeBlock block{{93, 108}, {53, 72}};
  std::vector<double> expected(at(table.rows() * table.columns()), missing);
  int count = 0;
  for (std::int64_t j = block.rows.begin; j < block.rows.end; ++j) {
    for (std::int64_t i = block.columns.begin; i < block.columns.end; ++i) {
      const Vector3 q = table.vector(i, j);
      bool is_inside = true;
      for (const Vector3 n : sides.normals) is_inside = is_inside && dot(n, q) > 1e-12;
      if (is_inside) expected[at(j * table.columns() + i)] = facet(q), ++count;
    }
  }
  ASSERT_GT(count, 50);
  ASSERT_TRUE(facet.formula().has_value());
  for (const GridKernels& kernels : grid_kernels()) {
    std::vector<double> out(expected.size(), missing);
    const NodeMask doubtful = kernels.fill_sphere(sides, *facet.formula(), axes, block,
                                                  {out.data(), table.columns()});
    EXPECT_EQ(bits_of(out), bits_of(expected));
    EXPECT_EQ(rows_of(doubtful, block), std::vector<std::uint64_t>(19, 0));
    const Cover cover = kernels.cover_sphere(sides, axes, block);
    int covered = 0;
    for_each_node(cover.inside, block, [&](std::int64_t i, std::int64_t j) {
      EXPECT_FALSE(std::isnan(expected[at(j * table.columns() + i)]));
      ++covered;
    });
    EXPECT_EQ(covered, count);
  }
}

TEST(GridLanes, TakeNothingBehindTheLastColumn) {
  PlaneCase c;
  c.block.columns = {13, 16};
  for (std::size_t k = 0; k < 3; ++k) c.sides.x[k] += 8;
  for (const GridKernels& kernels : grid_kernels()) {
    const Cover cover = kernels.cover_plane(c.sides, {c.x.data(), c.y.data()}, c.block);
    for (std::int64_t r = 0; r < 7; ++r) {
      EXPECT_EQ((cover.inside.rows[r] | cover.doubtful.rows[r]) >> 3, 0u);
    }
  }
}

BlendModel<3> model(double value, double slope) {
  BlendModel<3> m{.value = value, .per_radius = 1, .least = -50, .most = 50};
  for (std::size_t k = 0; k < m.coefficients.size(); ++k)
    m.coefficients[k] = slope / static_cast<double>(k + 1);
  return m;
}

TEST(BlendLanes, OfEveryInstructionSetGiveTheBitsOfSinglePoints) {
  const BlendModel<3> a = model(1, 0.3), b = model(-2, 0.7), c = model(0.5, -0.4);
  const BlendFacet<PlaneSpace, 3> facet(
      {{{{0, 0}, {1, 0.1}, {0.3, 0.9}}}, {&a, &b, &c}, {{{0.1, 0.2, 0.3}, {}, {}}}});
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.05, 0.3);
  NodeBatch batch;
  std::vector<double> expected, values(21);
  for (double& value : values) {
    const double s = part(random), t = part(random);
    const Point2 p{s + 0.3 * t, 0.1 * s + 0.9 * t};
    batch.add(&value, p.x, p.y);
    expected.push_back(facet(p));
  }
  batch.fill_lanes();
  const auto expect_same = [&](std::uint64_t open) {
    EXPECT_EQ(open, 0u);
    EXPECT_EQ(bits_of(values), bits_of(expected));
    std::fill(values.begin(), values.end(), missing);
  };
  expect_same(facet.fill_groups_as<delaunay::Portable>(batch));
  expect_same(fill_groups(facet, batch));
#if defined(__x86_64__)
  if (delaunay::Avx2::is_supported()) expect_same(fill_groups_avx2(facet, batch));
#endif
}

// More queries than a batch holds in one triangle, more than a chunk in all; nodes,
// points of edges, points outside and points that are no points among them.
TEST(C1Values, OfManyQueriesAreThoseOfSingleOnesInThePlane) {
  const auto points = support::uniform_points(40, 1);
  const PlaneC1 surface(support::triangulated(points), random_values(40, 2),
                        {SurfaceOptions{.outside = Outside::nearest}});
  support::PlanePoints queries = support::uniform_points(6000, 3);
  for (const auto& p : points) queries.push_back(p);
  queries.push_back({missing, 0.5});
  queries.push_back({7, -3});
  const std::vector<double> values = surface.values(queries);
  for (std::size_t i = 0; i < queries.size(); i += i < 5900 ? 7 : 1)
    ASSERT_TRUE(support::is_same(values[i], surface.value(queries[i]))) << i;
  EXPECT_EQ(bits_of(surface.values(queries, {.num_threads = 3, .progress = {}})),
            bits_of(values));
}

TEST(C1Values, OfManyQueriesAreThoseOfSingleOnesOnTheSphere) {
  const auto points = support::uniform_directions(40, 1);
  const SphereC1 surface(support::triangulated(points), random_values(40, 2));
  support::SpherePoints queries = support::uniform_directions(6000, 3);
  for (const auto& p : points) queries.push_back(p);
  const std::vector<double> values = surface.values(queries);
  for (std::size_t i = 0; i < queries.size(); i += i < 5900 ? 7 : 1)
    ASSERT_TRUE(support::is_same(values[i], surface.value(queries[i]))) << i;
}

}  // namespace
}  // namespace delone::interp
