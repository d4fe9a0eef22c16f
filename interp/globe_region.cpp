#include <algorithm>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/grid.hpp"
#include "interp/index.hpp"

namespace delone::interp {

namespace {

using stripack::Direction;
using stripack::LonLat;
using stripack::Triangulation;

bool holds_pole(const Triangulation& t, double lat_deg) {
  return t.locate(Direction::from(LonLat{0, lat_deg})).kind !=
         delaunay::Location::Kind::outside;
}

// The shortest interval that holds all longitudes: from behind the widest gap once around
// to before it.
Region between_widest_gap(std::vector<double> longitudes) {
  std::sort(longitudes.begin(), longitudes.end());
  Region r{longitudes.front(), longitudes.back(), 0, 0};
  double widest = longitudes.front() + 360 - longitudes.back();
  for (std::size_t i = 1; i < longitudes.size(); ++i) {
    const double gap = longitudes[i] - longitudes[i - 1];
    if (gap <= widest) continue;
    widest = gap;
    r.west = longitudes[i];
    r.east = longitudes[i - 1] + 360;
  }
  return r;
}

}  // namespace

Region covering_region(const Triangulation& triangulation) {
  constexpr Region globe{-180, 180, -90, 90};
  if (triangulation.num_sites() == 0) throw Error("there are no points to cover");
  if (holds_pole(triangulation, 90) || holds_pole(triangulation, -90)) return globe;
  std::vector<double> longitudes;
  double south = 90, north = -90;
  for (const Direction& p : triangulation.points()) {
    const LonLat place = stripack::lonlat(p);
    longitudes.push_back(place.lon_deg);
    south = std::min(south, place.lat_deg);
    north = std::max(north, place.lat_deg);
  }
  const Region r = between_widest_gap(std::move(longitudes));
  if (r.east - r.west > 180) return globe;
  return {r.west, r.east, south, north};
}

}  // namespace delone::interp
