#include "io/lonlat_rings.hpp"

#include <algorithm>
#include <cmath>

#include "stripack/direction.hpp"

namespace delone::io {
namespace {

bool is_pole(const std::array<double, 2>& p) { return std::abs(p[1]) == 90; }

double wrapped(double lon) {
  const double turned = std::remainder(lon, 360);
  return turned;
}

/// The latitude at which the great circle through a and b meets the meridian at +-180.
double latitude_at_date_line(const std::array<double, 2>& a,
                             const std::array<double, 2>& b) {
  const auto p = stripack::Direction::from({a[0], a[1]});
  const auto q = stripack::Direction::from({b[0], b[1]});
  // The normal n = p x q; a point (-c, 0, s) of the meridian has n.z s = n.x c.
  const double nx = p.y() * q.z() - p.z() * q.y(), nz = p.x() * q.y() - p.y() * q.x();
  if (nz == 0) return (a[1] + b[1]) / 2;
  return std::clamp(lonlat(stripack::Direction::from(-1, 0, nx / nz)).lat_deg, -90.0,
                    90.0);
}

/// The ring with longitudes that run on from corner to corner, led around poles that it
/// touches or holds.
class Unwrapper {
 public:
  explicit Unwrapper(const PlaneRing& corners) : corners_(corners) {}

  PlaneRing unwrap() {
    const auto first = std::ranges::find_if_not(corners_, is_pole);
    if (first == corners_.end()) return corners_;
    std::rotate(corners_.begin(), first, corners_.end());
    ring_.push_back({wrapped(corners_[0][0]), corners_[0][1]});
    for (std::size_t i = 1; i < corners_.size(); ++i) go_to(corners_[i]);
    go_to(corners_[0]);
    close();
    return std::move(ring_);
  }

 private:
  /// Appends a corner at the longitude nearest to that of the last one.
  void go_to(const std::array<double, 2>& corner) {
    if (is_pole(corner)) {
      ring_.push_back({ring_.back()[0], corner[1]});
      is_at_pole_ = true;
      return;
    }
    const auto [lon, lat] = ring_.back();
    const double step = std::remainder(corner[0] - lon, 360);
    const double next = lon + step;
    if (is_at_pole_) {
      ring_.push_back({next, lat});
      is_at_pole_ = false;
    } else if (std::abs(step) == 180) {
      const double pole = lat + corner[1] >= 0 ? 90 : -90;
      ring_.push_back({lon, pole});
      ring_.push_back({next, pole});
    }
    ring_.push_back({next, corner[1]});
  }

  /// The walk has come back to the first corner, or to its image one turn on: then the
  /// pole on its left is inside.
  void close() {
    const double turn = ring_.back()[0] - ring_.front()[0];
    if (std::abs(turn) < 180) {
      ring_.pop_back();
      return;
    }
    const double pole = turn > 0 ? 90 : -90;
    ring_.push_back({ring_.back()[0], pole});
    ring_.push_back({ring_.front()[0], pole});
  }

  PlaneRing corners_, ring_;
  bool is_at_pole_ = false;
};

/// The part of `ring` on one side of the meridian `lon`: where sign * (x - lon) >= 0.
PlaneRing clipped(const PlaneRing& ring, double lon, double sign) {
  PlaneRing part;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    const double from = sign * (a[0] - lon), to = sign * (b[0] - lon);
    if (from >= 0) part.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
      const bool is_along_pole = a[1] == b[1] && is_pole(a);
      part.push_back({lon, is_along_pole ? a[1] : latitude_at_date_line(a, b)});
    }
  }
  return part;
}

double extent(const PlaneRing& ring) {
  const auto [low, high] =
      std::ranges::minmax(ring, {}, [](const std::array<double, 2>& p) { return p[0]; });
  return high[0] - low[0];
}

}  // namespace

std::vector<PlaneRing> cut_at_date_line(const PlaneRing& corners) {
  if (corners.size() < 3) return {corners};
  PlaneRing ring = Unwrapper(corners).unwrap();
  double west = ring[0][0];
  for (const auto& [lon, lat] : ring) west = std::min(west, lon);
  const double turns = 360 * std::floor((west + 180) / 360);
  for (auto& corner : ring) corner[0] -= turns;
  std::vector<PlaneRing> rings{clipped(ring, 180, -1), clipped(ring, 180, 1)};
  for (auto& corner : rings[1]) corner[0] -= 360;
  // A ring that only touches the date line leaves nothing on its other side.
  std::erase_if(rings, [](const PlaneRing& r) { return r.size() < 3 || extent(r) == 0; });
  if (rings.empty()) return {ring};
  return rings;
}

}  // namespace delone::io
