#include "bench/cgal_peer.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_on_sphere_2.h>
#include <CGAL/Delaunay_triangulation_on_sphere_traits_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Projection_on_sphere_traits_3.h>

#include <memory>
#include <vector>

namespace delone::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Traits>
Builder on_sphere(std::span<const stripack::Direction> points) {
  using Triangulation = CGAL::Delaunay_triangulation_on_sphere_2<Traits>;
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size());
  for (const auto& d : points) input.emplace_back(d.x(), d.y(), d.z());
  return [input = std::move(input)] {
    const Traits traits(Kernel::Point_3(0, 0, 0), 1);
    auto built = std::make_shared<Triangulation>(traits);
    built->insert(input.begin(), input.end());
    return Built{built, static_cast<std::int64_t>(built->number_of_solid_faces())};
  };
}

}  // namespace

Builder cgal_plane(std::span<const tripack::Point2> points) {
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;
  std::vector<Kernel::Point_2> input;
  input.reserve(points.size());
  for (const auto& p : points) input.emplace_back(p.x, p.y);
  return [input = std::move(input)] {
    auto built = std::make_shared<Triangulation>();
    built->insert(input.begin(), input.end());
    return Built{built, static_cast<std::int64_t>(built->number_of_faces())};
  };
}

Builder cgal_sphere(std::span<const stripack::Direction> points) {
  return on_sphere<CGAL::Delaunay_triangulation_on_sphere_traits_2<Kernel>>(points);
}

Builder cgal_sphere_projected(std::span<const stripack::Direction> points) {
  return on_sphere<CGAL::Projection_on_sphere_traits_3<Kernel>>(points);
}

}  // namespace delone::bench
