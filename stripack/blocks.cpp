#include "stripack/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "delaunay/error.hpp"

namespace delone::stripack {

namespace {

// The longitude in [west, west + 360], exact where it lies there already.
double wrapped(double lon_deg, double west) {
  if (lon_deg >= west && lon_deg < west + 360) return lon_deg;
  const double lon = lon_deg - 360 * std::floor((lon_deg - west) / 360);
  return lon >= west + 360 ? west : std::max(lon, west);
}

void check(std::span<const LonLat> points, const BlockOptions& options) {
  if (options.region && options.region->east - options.region->west > 360)
    throw Error("the region of the blocks spans more than 360 degrees");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(points[i].lat_deg) <= 90 && std::isfinite(points[i].lon_deg)) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("row " + std::to_string(row) +
                    ": longitude and latitude must be finite, latitude in -90..90 "
                    "degrees; remove the row",
                {row});
  }
}

}  // namespace

Blocks block_reduce(std::span<const LonLat> points, std::span<const double> values,
                    std::span<const double> weights, const BlockOptions& options) {
  check(points, options);
  const double west = options.region ? options.region->west : -180;
  std::vector<double> lon, lat;
  for (const LonLat& p : points) {
    lon.push_back(std::abs(p.lat_deg) == 90 ? west : wrapped(p.lon_deg, west));
    lat.push_back(p.lat_deg);
  }
  if (options.region) return delaunay::block_reduce(lon, lat, values, weights, options);
  BlockOptions globe = options;
  globe.region = BlockRegion{-180, 180, -90, 90};
  return delaunay::block_reduce(lon, lat, values, weights, globe);
}

}  // namespace delone::stripack
