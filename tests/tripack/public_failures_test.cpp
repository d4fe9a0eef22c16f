// Planar input that made other codes fail in public, each with the thread where it was
// reported (owner/repository and number on GitHub).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "support/corpus.hpp"
#include "support/exact.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/defect.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {
namespace {

using support::PlanePoints;
using Limits = std::numeric_limits<double>;

PlanePoints corpus(const std::string& name) {
  static const auto cases = support::plane_corpus(DELONE_CORPUS_DIR);
  const auto found = std::find_if(cases.begin(), cases.end(),
                                  [&](const auto& c) { return c.name == name; });
  if (found == cases.end()) throw std::invalid_argument("no case " + name);
  return found->plane;
}

double number(std::size_t i) { return static_cast<double>(i); }

template <class F>
PlanePoints count(std::size_t n, F point) {
  PlanePoints points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(point(number(i)));
  return points;
}

PlanePoints arc(std::size_t n, double degrees) {
  return count(n, [&](double i) {
    const double a = i * degrees * std::numbers::pi / 180;
    return Point2{std::cos(a), std::sin(a)};
  });
}

// seq(.25, 50, .25) by seq(.5, 50, .25): 200 x 199 points, all ties.
PlanePoints quarters() {
  return count(200 * 199, [](double i) {
    const double row = std::floor(i / 200);
    return Point2{0.25 + 0.25 * (i - 200 * row), 0.5 + 0.25 * row};
  });
}

struct PublicFailure {
  const char* thread;
  const char* what;
  PlanePoints (*points)();
};
void PrintTo(const PublicFailure& f, std::ostream* out) {
  *out << f.thread << ": " << f.what;
}

const PublicFailure failures[] = {
    {"geotrellis/geotrellis#1755", "all collinear, not along an axis",
     [] { return count(50, [](double i) {
            return Point2{i, 2 * i + 1};
          }); }},
    {"DanielVandH/DelaunayTriangulation.jl#6", "(v, v) for v = 0, 0.01, ... 1",
     [] { return corpus("plane_collinear_hundredths"); }},
    {"DanielVandH/DelaunayTriangulation.jl#18", "collinear on an axis",
     [] { return count(9, [](double i) {
            return Point2{0, i};
          }); }},
    {"noinia/hgeometry#209", "collinear with equal x: no end",
     [] { return count(20, [](double i) {
            return Point2{1, 19 - i};
          }); }},
    {"qhull/QH6154", "initial simplex is flat",
     [] { return count(4, [](double i) {
            return Point2{0.1 * i, 0.3 * i};
          }); }},
    {"mapbox/delaunator#61", "square lattice turned by 302.328 degrees",
     [] { return corpus("plane_lattice_turned_302_degrees"); }},
    {"abellgithub/delaunator-cpp#8", "turned square lattice",
     [] { return support::rotated_lattice_points(400, 45); }},
    {"matplotlib/matplotlib#4437", "turned square lattice",
     [] { return support::rotated_lattice_points(100, 10); }},
    {"go-hep/hep#72", "lattice turned by 25 degrees, 5 and more a side: no end",
     [] { return corpus("plane_lattice_turned_25_degrees"); }},
    {"davidcsterratt/geometry#10", "lattice of quarters", quarters},
    {"scipy/scipy#6257", "lattice, killed at 10 million points",
     [] { return support::lattice_points(40000); }},
    {"LLNL/axom#1861", "lattice of tenths",
     [] {
       return count(400, [](double i) {
         return Point2{0.1 * std::fmod(i, 20), 0.1 * std::floor(i / 20)};
       });
     }},
    {"msokalski/delabella#8", "17 points of a circle",
     [] { return corpus("plane_polygon_17"); }},
    {"msokalski/delabella#15", "five points of an arc, a degree apart",
     [] { return corpus("plane_arc_of_five_degrees"); }},
    {"CGAL/cgal#6452 square", "a square", [] { return corpus("plane_square"); }},
    {"CGAL/cgal#6452 octagon", "a regular octagon",
     [] { return corpus("plane_polygon_8"); }},
    {"CGAL/cgal#6452 16-gon", "16 corners", [] { return corpus("plane_polygon_16"); }},
    {"mapbox/delaunator#13", "a hundred degrees of a circle", [] { return arc(100, 1); }},
    {"davidcsterratt/geometry#4", "five degrees of a circle", [] { return arc(5, 1); }},
    {"mapbox/delaunator#43", "four points, hull almost collinear",
     [] {
       PlanePoints points = corpus("plane_hull_almost_collinear");
       points.resize(4);
       return points;
     }},
    {"d3/d3-delaunay#142", "the same and one point beside",
     [] { return corpus("plane_hull_almost_collinear"); }},
    {"d3/d3-voronoi#24", "x = 399.999779 and 399.999780",
     [] { return corpus("plane_micrometre_apart"); }},
    {"artem-ogre/CDT#174", "three points one to four ulps apart",
     [] { return corpus("plane_three_points_ulps_apart"); }},
    {"matplotlib/matplotlib#838", "two of seven points repeated: hangs",
     [] { return corpus("plane_repeats"); }},
    {"drufat/triangle#4", "the last point is the first",
     [] {
       return PlanePoints{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
     }},
    {"drufat/triangle#70", "repeated points: crashes the interpreter",
     [] {
       PlanePoints points = support::uniform_points(20, 3);
       points.insert(points.end(), points.begin(), points.begin() + 20);
       return points;
     }},
    {"artem-ogre/CDT#154", "{0, 1e38}, {1, 1e38}: no end",
     [] { return corpus("plane_1e38"); }},
    {"georust/robust#19 1e300", "squares overflow", [] { return corpus("plane_1e300"); }},
    {"georust/robust#19 largest", "differences overflow",
     [] { return corpus("plane_largest_doubles"); }},
    {"JuliaGeometry/AdaptivePredicates.jl#4", "(0, 0), (0, 5e-324), (5e-324, 0)",
     [] { return corpus("plane_smallest_doubles"); }},
    {"locationtech/jts#1197", "products underflow: 1e-170",
     [] { return corpus("plane_products_underflow"); }},
    {"openscad/openscad#2220", "1e-300",
     [] {
       return count(25, [](double i) {
         return Point2{1e-300 * std::fmod(i, 5), 1e-300 * std::floor(i / 5)};
       });
     }},
    {"shapely/shapely#555", "one point at 2.8e8, the rest within 1e-3",
     [] { return corpus("plane_mixed_scale"); }},
    {"r-lidar/lidR#143", "a box of width 1 at 5.1e6",
     [] { return corpus("plane_far_from_origin"); }},
    {"libgeos/geos#946", "eight almost collinear points in UTM metres",
     [] { return corpus("plane_utm_almost_collinear"); }},
    {"handley-lab/anesthetic#436", "x within 1e-6 of 0.9635, y from 1e2 to 1e6",
     [] { return corpus("plane_stretched"); }},
    {"python-adaptive/adaptive#181", "a triangle of 1e-6 by 53",
     [] { return corpus("plane_needle"); }},
    {"DanielVandH/DelaunayTriangulation.jl#94", "(.5, .5), (.2, .8), (0, 1): no end",
     [] {
       return PlanePoints{{0.5, 0.5}, {0.2, 0.8}, {0, 1}};
     }},
    {"gwlucastrig/Tinfour#84", "sorted and in random order",
     [] { return support::shuffled(support::lattice_points(10000), 1); }},
    {"BrunoLevy/geogram#108", "nine points in symmetry",
     [] { return corpus("plane_octahedral_nine"); }},
    {"artem-ogre/CDT#65", "three points: 1, 0, 0, 1 triangles in four runs",
     [] {
       return PlanePoints{{0, 0}, {1, 0}, {0, 1}};
     }},
    {"pode#15", "points in strips of 1e-6 by 53",
     [] {
       return count(200, [](double i) {
         return Point2{1e-6 * std::fmod(i, 2), std::fmod(37 * i, 53)};
       });
     }},
    {"BrunoLevy/geogram#358", "near ties that contraction decides wrongly: no end",
     [] { return support::polygon_points(300, 1); }},
};

class PlanePublicFailure : public testing::TestWithParam<PublicFailure> {};

TEST_P(PlanePublicFailure, IsTriangulatedExactly) {
  const PlanePoints points = GetParam().points();
  const Triangulation t(points);
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
  if (points.size() < 2000) {
    EXPECT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
  }
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Triangulation shuffled(support::shuffled(points, seed));
    EXPECT_TRUE(shuffled.adjacency() == t.adjacency());
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, PlanePublicFailure, testing::ValuesIn(failures),
                         [](const auto& failure) {
                           std::string name = failure.param.thread;
                           for (char& c : name)
                             c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

// scipy/scipy#22831: a point computed on the edge from (0, 0) to (3, -2) at 0.6 was in no
// triangle. scipy/scipy#9737: nor was a node.
TEST(PlanePublicFailureOfQueries, FindAPointComputedOnAnEdge) {
  const PlanePoints points = corpus("plane_edge_query");
  const Triangulation t(points);
  for (int k = 0; k <= 10; ++k) {
    const Point2 p{3 * (k / 10.0), -2 * (k / 10.0)};
    const int side = support::exact_orientation(points[0], points[1], p);
    const auto kind = t.locate(p).kind;
    if (k == 0 || k == 10) {
      EXPECT_EQ(kind, Location::Kind::node);
    } else {
      // The third node is on the left.
      EXPECT_EQ(kind, side == 0 ? Location::Kind::edge
                                : (side > 0 ? Location::Kind::triangle
                                            : Location::Kind::outside));
    }
  }
  for (const Point2 p : points) EXPECT_EQ(t.locate(p).kind, Location::Kind::node);
}

// fogleman/delaunay#7, d3/d3-delaunay#19 and #20: NaN, infinities, no point, one, two.
TEST(PlanePublicFailureOfInput, IsRefusedByRowOrIsAValue) {
  for (const double bad :
       {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (const Point2 p : {Point2{bad, 0}, Point2{0, bad}}) {
      try {
        const Triangulation t(PlanePoints{{0, 0}, {1, 0}, p, {0, 1}});
        ADD_FAILURE() << "taken";
      } catch (const Error& error) {
        ASSERT_EQ(error.rows().size(), 1u);
        EXPECT_EQ(error.rows()[0], 2);
      }
    }
  }
  EXPECT_EQ(Triangulation(PlanePoints{}).dimension(), -1);
  EXPECT_EQ(Triangulation(PlanePoints{{1, 2}}).dimension(), 0);
  EXPECT_EQ(Triangulation(PlanePoints{{1, 2}, {3, 4}}).dimension(), 1);
}

// scipy/scipy#17378: deleting far-away points of a lattice changed the triangles, and so
// the interpolated values, elsewhere.
TEST(PlanePublicFailureOfTies, DoNotDependOnFarAwayPoints) {
  const auto triangles_near = [](std::size_t rows) {
    const PlanePoints points = count(20 * rows, [](double i) {
      return Point2{std::fmod(i, 20), std::floor(i / 20)};
    });
    auto triangles = Triangulation(points).triangles();
    std::erase_if(triangles, [](const auto& t) {
      return *std::max_element(t.begin(), t.end()) >= 20 * 8;
    });
    return triangles;
  };
  EXPECT_EQ(triangles_near(10), triangles_near(20));
  EXPECT_EQ(triangles_near(10), triangles_near(13));
}

// CGAL/cgal#2922, BrunoLevy/geogram#108: few points in parallel, out of bounds.
TEST(PlanePublicFailureOfThreads, FewPointsAreBuiltAlikeByAnyNumber) {
  for (std::size_t n = 1; n <= 20; ++n) {
    const PlanePoints points = support::lattice_points(n);
    const Triangulation one(points, {.num_threads = 1, .progress = {}});
    for (const int threads : {2, 3, 8, 64}) {
      const Triangulation many(points, {.num_threads = threads, .progress = {}});
      EXPECT_TRUE(many.adjacency() == one.adjacency());
    }
  }
}

}  // namespace
}  // namespace delone::tripack
