#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

#include "delaunay/buffer.hpp"
#include "delaunay/parallel.hpp"
#include "interp/globe_table.hpp"
#include "interp/grid_lanes.hpp"

namespace delone::interp {

/// Where sites lie on a longitude-latitude grid: computed once for every site, not once
/// for every triangle that meets in it.
//
// Longitude grows or falls all along an arc of a great circle, so a triangle without a
// pole lies between the longitudes of its corners. In latitude it reaches beyond them by
// no more than its longest side bends.
class SphereScanPlaces {
 public:
  SphereScanPlaces(std::span<const Direction> sites, const GlobeTable& table,
                   const RunOptions& run)
      : table_(table), places_(sites.size()) {
    constexpr std::int64_t chunk = 4096;
    const RunOptions quietly{.num_threads = run.num_threads, .progress = {}};
    delaunay::parallel_chunks(static_cast<std::int64_t>(sites.size()), chunk, quietly,
                              [&](std::int64_t first, std::int64_t last) {
                                for (std::int64_t s = first; s < last; ++s)
                                  places_[at(s)] = place(sites[at(s)]);
                              });
  }

  /// The nodes around a triangle that is small and away from the poles, its columns in
  /// the turn of its first corner: positions low .. high.
  struct Box {
    double low, high;
    IndexRange rows;
  };
  [[nodiscard]] std::optional<Box> box(const std::array<delaunay::Site, 3>& corners,
                                       const std::array<Vector3, 3>& p) const {
    const Vector3 u = p[1] - p[0], w = p[2] - p[0], v = w - u;
    const double reach = std::max(dot(u, u), dot(w, w));
    // Within a fifth of the first corner's distance from the axis: no pole.
    if (!(reach < 0.04 * (p[0].x * p[0].x + p[0].y * p[0].y))) return {};
    // An arc rises above its chord c by 1 - cos(h), sin(h) = c / 2 < 0.2.
    const double bend = 0.13 * std::max(reach, dot(v, v));
    const Place a = places_[at(corners[0])], b = places_[at(corners[1])],
                c = places_[at(corners[2])];
    const double to_b = nearest_turn(b.column - a.column),
                 to_c = nearest_turn(c.column - a.column);
    return Box{a.column + std::min(0.0, std::min(to_b, to_c)) - slack_,
               a.column + std::max(0.0, std::max(to_b, to_c)) + slack_,
               rows(std::min(a.row, std::min(b.row, c.row)),
                    std::max(a.row, std::max(b.row, c.row)),
                    std::min(p[0].z, std::min(p[1].z, p[2].z)) - bend,
                    std::max(p[0].z, std::max(p[1].z, p[2].z)) + bend)};
  }

 private:
  struct Place {
    double column;     // position of its longitude, some turn
    std::int64_t row;  // the first whose sine is not below its own
  };

  [[nodiscard]] Place place(const Direction& p) const {
    constexpr double degrees = 180 / std::numbers::pi;
    return {table_.lon().position(std::atan2(p.y(), p.x()) * degrees),
            table_.first_row_from(p.z())};
  }

  [[nodiscard]] double nearest_turn(double difference) const {
    if (difference > turn_ / 2) return difference - turn_;
    return difference < -turn_ / 2 ? difference + turn_ : difference;
  }

  [[nodiscard]] IndexRange rows(std::int64_t first, std::int64_t last, double low,
                                double high) const {
    while (first > 0 && table_.sin_lat(first - 1) >= low) --first;
    while (last < table_.rows() && table_.sin_lat(last) <= high) ++last;
    while (first < last && table_.is_pole(first)) ++first;
    while (first < last && table_.is_pole(last - 1)) --last;
    return {first, last};
  }

  const GlobeTable& table_;
  double turn_ = table_.turn();
  // Longitudes and nodes are off by some roundings.
  double slack_ = table_.tolerance() + 0x1p-20 + 0x1p-40 * turn_;
  delaunay::Buffer<Place> places_;
};

}  // namespace delone::interp
