// Does CGAL find the same triangles where the triangulation is unique? Random sets, which
// have no ties; on the sphere points that CGAL keeps (none closer than 2^-25).
//
//   agrees_with_cgal [POINTS] [SETS]
//
// Exit code 1 if a set differs.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_on_sphere_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Projection_on_sphere_traits_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stripack/triangulation.hpp"
#include "support/plane_sets.hpp"
#include "support/sphere_sets.hpp"
#include "tripack/triangulation.hpp"

namespace {

using namespace delone;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<std::array<std::int32_t, 3>>;

Triangles in_canonical_form(Triangles triangles) {
  for (auto& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Triangles cgal_triangles(const support::PlanePoints& points) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
  std::vector<std::pair<Kernel::Point_2, std::int32_t>> rows;
  for (const auto& p : points)
    rows.emplace_back(Kernel::Point_2(p.x, p.y), static_cast<std::int32_t>(rows.size()));
  const CGAL::Delaunay_triangulation_2<Kernel, Structure> t(rows.begin(), rows.end());
  Triangles triangles;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    triangles.push_back(
        {f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return in_canonical_form(std::move(triangles));
}

Triangles cgal_triangles(const support::SpherePoints& points) {
  using Traits = CGAL::Projection_on_sphere_traits_3<Kernel>;
  CGAL::Delaunay_triangulation_on_sphere_2<Traits> t(Traits(Kernel::Point_3(0, 0, 0), 1));
  std::map<std::array<double, 3>, std::int32_t> row_of;
  std::vector<Kernel::Point_3> rows;
  for (const auto& d : points) {
    row_of[{d.x(), d.y(), d.z()}] = static_cast<std::int32_t>(rows.size());
    rows.emplace_back(d.x(), d.y(), d.z());
  }
  t.insert(rows.begin(), rows.end());
  Triangles triangles;
  for (auto f = t.solid_faces_begin(); f != t.solid_faces_end(); ++f) {
    const auto row = [&](int k) {
      const auto& p = f->vertex(k)->point();
      return row_of.at({p.x(), p.y(), p.z()});
    };
    triangles.push_back({row(0), row(1), row(2)});
  }
  return in_canonical_form(std::move(triangles));
}

template <class Triangulation, class Points>
bool agrees(const std::string& name, const Points& points) {
  const Triangles ours = Triangulation(points).triangles(),
                  theirs = cgal_triangles(points);
  std::printf("%s: %zu triangles, CGAL %zu: %s\n", name.c_str(), ours.size(),
              theirs.size(), ours == theirs ? "the same" : "DIFFERENT");
  return ours == theirs;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::stoull(argv[1]) : 20000;
  const std::uint64_t num_sets = argc > 2 ? std::stoull(argv[2]) : 3;
  bool all = true;
  for (std::uint64_t seed = 1; seed <= num_sets; ++seed) {
    for (const auto& family : support::plane_families()) {
      for (const char* name : {"uniform", "clusters", "kuzmin", "far_from_origin",
                               "stretched", "line_clustered", "tiny"}) {
        if (std::string(name) == family.name)
          all &= agrees<tripack::Triangulation>(std::string("plane ") + name,
                                                family.make(n, seed));
      }
    }
    for (const auto& family : support::sphere_families()) {
      for (const char* name : {"uniform", "cap_40", "hemisphere_open", "cap_170"}) {
        if (std::string(name) == family.name)
          all &= agrees<stripack::Triangulation>(std::string("sphere ") + name,
                                                 family.make(n, seed));
      }
    }
  }
  return all ? 0 : 1;
}
