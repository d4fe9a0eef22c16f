#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/neighbor_table.hpp"
#include "delaunay/options.hpp"
#include "stripack/triangulation.hpp"

/// The nodes near a point of the sphere: the nearest k, all within a radius, one after
/// the other.
///
/// The order is exact for the directions of the stored triples: no rounding decides which
/// of two nodes is nearer, and nodes exactly as far as one another come in the order of
/// their coordinates (x, y, z), so that answers depend neither on the order of rows nor
/// on threads. Distances are angles in radians (times earth_radius_km: great-circle
/// kilometres), to 4 units in the last place and 2^-51, and never decrease along a list.
/// A node is a position: repeated rows are one, and its first row is named.
///
/// Cost of k nodes after the walk: the sum of their degrees, times log k; about a
/// microsecond for k = 8. Beyond 90 degrees from a set that lies in a hemisphere there
/// are neighbours that the lists do not have, and all boundary nodes are looked at. All
/// throw Error for a k below 1 and a radius that is negative or NaN.
///
/// The functions named wgs84 take directions as geodetic latitudes and order by geodesic
/// distance on WGS84, in kilometres, as GeographicLib computes it (within 15 nanometres;
/// ties of computed distances in the order of angles). They are complete: on the way from
/// directions to the ellipsoid every length is stretched by the radii of curvature, b^2 /
/// a = 6335.44 km to a^2 / b = 6399.60 km, so that a node that is farther than
/// (a / b)^3 = 1.0102 times the angle of another cannot be nearer.
///
/// Source: the i + 1 nearest sites are connected in the Delaunay triangulation; F. P.
/// Preparata, M. I. Shamos, Computational Geometry (1985), 5.6.
namespace delone::stripack {

using delaunay::Neighbor;
using delaunay::NeighborTable;

/// The row of the node nearest to `p`; none if there is no node. `hint`: a row near p.
[[nodiscard]] Node nearest_exact(const Triangulation& t, const Direction& p,
                                 Node hint = delaunay::none);

/// The k nodes nearest to `p`, or all if there are fewer.
[[nodiscard]] std::vector<Neighbor> nearest_k(const Triangulation& t, const Direction& p,
                                              std::int32_t k, Node hint = delaunay::none);

/// All nodes whose distance from `p`, as it is given here, is at most `radius` radians.
[[nodiscard]] std::vector<Neighbor> nodes_within(const Triangulation& t,
                                                 const Direction& p, double radius,
                                                 Node hint = delaunay::none);

/// nearest_k of many points. They are visited along a curve and answered in their order.
[[nodiscard]] NeighborTable nearest_k(const Triangulation& t,
                                      std::span<const Direction> queries, std::int32_t k,
                                      const RunOptions& run = {});

/// nodes_within of many points.
[[nodiscard]] NeighborTable nodes_within(const Triangulation& t,
                                         std::span<const Direction> queries,
                                         double radius, const RunOptions& run = {});

/// For every row of the triangulation the k nearest other nodes.
[[nodiscard]] NeighborTable nearest_k_of_nodes(const Triangulation& t, std::int32_t k,
                                               const RunOptions& run = {});

/// The k nodes nearest to `p` along geodesics of WGS84; distances in kilometres.
[[nodiscard]] std::vector<Neighbor> nearest_k_wgs84(const Triangulation& t,
                                                    const Direction& p, std::int32_t k,
                                                    Node hint = delaunay::none);
/// All nodes at most `radius_km` kilometres away along geodesics of WGS84.
[[nodiscard]] std::vector<Neighbor> nodes_within_wgs84(const Triangulation& t,
                                                       const Direction& p,
                                                       double radius_km,
                                                       Node hint = delaunay::none);
/// The same for many points. 1 to 2 microseconds a node looked at.
[[nodiscard]] NeighborTable nearest_k_wgs84(const Triangulation& t,
                                            std::span<const Direction> queries,
                                            std::int32_t k, const RunOptions& run = {});
[[nodiscard]] NeighborTable nodes_within_wgs84(const Triangulation& t,
                                               std::span<const Direction> queries,
                                               double radius_km,
                                               const RunOptions& run = {});

/// The nodes in the order of their distances from a point, one at a time: GETNP.
///
/// Keeps a reference to the triangulation, which must outlive it. For one thread.
class NearestNodes {
 public:
  explicit NearestNodes(const Triangulation& t);
  ~NearestNodes();
  NearestNodes(NearestNodes&&) noexcept;
  NearestNodes& operator=(NearestNodes&&) noexcept;

  /// Begins at the node nearest to `p`.
  void start(const Direction& p, Node hint = delaunay::none);
  /// The next node; nothing after the last, and before `start`.
  [[nodiscard]] std::optional<Neighbor> next();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delone::stripack
