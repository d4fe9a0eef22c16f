#include "tripack/polygon_clip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace delone::tripack {

namespace {

// A run of corners inside, between the point where the boundary comes in and the one
// where it goes out.
struct Chain {
  Polygon corners;
  double entry = 0, exit = 0;  // places along the line
};

// Along the line, with the half-plane on the left.
double place(const HalfPlane& half, Point2 p) {
  return half.normal.x * p.y - half.normal.y * p.x;
}

std::vector<Chain> chains_of(const Polygon& polygon, const std::vector<double>& heights,
                             const HalfPlane& half, std::size_t start) {
  const std::size_t n = polygon.size();
  std::vector<Chain> chains;
  for (std::size_t k = 0; k < n; ++k) {  // polygon[start] is outside
    const std::size_t i = (start + k) % n, j = (start + k + 1) % n;
    const bool is_in = heights[i] <= 0, comes_in = heights[j] <= 0;
    if (is_in) chains.back().corners.push_back(polygon[i]);
    if (is_in == comes_in) continue;
    const Point2 p = is_in ? crossing(polygon[i], polygon[j], heights[i], heights[j])
                           : crossing(polygon[j], polygon[i], heights[j], heights[i]);
    if (!is_in) chains.push_back({{}, place(half, p), 0});
    chains.back().corners.push_back(p);
    if (is_in) chains.back().exit = place(half, p);
  }
  return chains;
}

// The line passes through a simple polygon in intervals: each begins where the boundary
// goes out of the half-plane and ends where it comes in. So the k-th exit along the line
// belongs to the k-th entry.
std::vector<std::size_t> successors(const std::vector<Chain>& chains) {
  std::vector<std::size_t> by_exit(chains.size()), by_entry(chains.size());
  for (std::size_t i = 0; i < chains.size(); ++i) by_exit[i] = by_entry[i] = i;
  std::sort(by_exit.begin(), by_exit.end(), [&](std::size_t a, std::size_t b) {
    return chains[a].exit < chains[b].exit;
  });
  std::sort(by_entry.begin(), by_entry.end(), [&](std::size_t a, std::size_t b) {
    return chains[a].entry < chains[b].entry;
  });
  std::vector<std::size_t> next(chains.size());
  for (std::size_t k = 0; k < chains.size(); ++k) next[by_exit[k]] = by_entry[k];
  return next;
}

std::vector<Polygon> join(std::vector<Chain> chains) {
  std::vector<Polygon> result;
  if (chains.size() == 1) {
    result.push_back(std::move(chains[0].corners));
    return result;
  }
  const std::vector<std::size_t> next = successors(chains);
  std::vector<bool> is_used(chains.size());
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (is_used[i]) continue;
    Polygon& ring = result.emplace_back();
    for (std::size_t k = i; !is_used[k]; k = next[k]) {
      is_used[k] = true;
      ring.insert(ring.end(), chains[k].corners.begin(), chains[k].corners.end());
    }
  }
  return result;
}

}  // namespace

HalfPlane nearer_to_origin(Point2 d) noexcept {
  const double largest = std::max(std::abs(d.x), std::abs(d.y));
  const Point2 unit{d.x / largest, d.y / largest};
  return {unit, (unit.x * unit.x + unit.y * unit.y) * largest / 2};
}

std::vector<Polygon> clip(Polygon polygon, const HalfPlane& half) {
  std::vector<double> heights(polygon.size());
  std::size_t num_outside = 0, start = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    heights[i] = height(half, polygon[i]);
    if (heights[i] <= 0) continue;
    ++num_outside;
    start = i;
  }
  if (num_outside == polygon.size()) return {};
  if (num_outside > 0) return join(chains_of(polygon, heights, half, start));
  std::vector<Polygon> whole;
  whole.push_back(std::move(polygon));
  return whole;
}

std::vector<Polygon> clip(std::vector<Polygon> polygons, const HalfPlane& half) {
  if (polygons.size() == 1) return clip(std::move(polygons[0]), half);
  std::vector<Polygon> result;
  for (Polygon& polygon : polygons) {
    for (Polygon& part : clip(std::move(polygon), half))
      result.push_back(std::move(part));
  }
  return result;
}

}  // namespace delone::tripack
