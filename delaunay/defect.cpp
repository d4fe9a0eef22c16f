#include "delaunay/defect.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace delone::delaunay {

namespace {

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

// Arc of a triangle: from -> to with the third corner on its left.
struct HalfEdge {
  Site from, to, third;
  friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

std::vector<HalfEdge> sorted_half_edges(std::span<const Triple> triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    edges.insert(edges.end(), {{a, b, c}, {b, c, a}, {c, a, b}});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// The fan of one site, put into counter-clockwise order.
struct Fan {
  std::vector<Site> ring;
  bool is_boundary = false;
  bool is_whole = true;  // false: several fans meet at the site
};

// `edges`: the half-edges that leave one site, sorted by their ends, all different.
Fan chain_fan(std::span<const HalfEdge> edges) {
  const auto edge_to = [&](Site w) {
    const auto at = std::lower_bound(edges.begin(), edges.end(), w,
                                     [](const HalfEdge& e, Site s) { return e.to < s; });
    return at != edges.end() && at->to == w ? at - edges.begin() : std::ptrdiff_t{-1};
  };
  std::vector<bool> is_third(edges.size(), false);
  for (const HalfEdge& e : edges) {
    if (const auto i = edge_to(e.third); i >= 0)
      is_third[static_cast<std::size_t>(i)] = true;
  }
  const auto start = std::find(is_third.begin(), is_third.end(), false);
  Fan fan;
  fan.is_boundary = start != is_third.end();
  auto i = fan.is_boundary ? start - is_third.begin() : 0;
  for (std::size_t steps = 0; steps < edges.size() && i >= 0; ++steps) {
    const HalfEdge& e = edges[static_cast<std::size_t>(i)];
    if (!fan.ring.empty() && e.to == fan.ring.front()) break;
    fan.ring.push_back(e.to);
    i = edge_to(e.third);
    if (i < 0) fan.ring.push_back(e.third);
  }
  fan.is_whole = fan.ring.size() == edges.size() + (fan.is_boundary ? 1 : 0);
  return fan;
}

Defect find_twin(std::span<const HalfEdge> edges, std::span<const Node> rows) {
  const auto twin = std::adjacent_find(edges.begin(), edges.end(),
                                       [](const HalfEdge& a, const HalfEdge& b) {
                                         return a.from == b.from && a.to == b.to;
                                       });
  if (twin == edges.end()) return std::nullopt;
  const auto row = [&](Site v) { return rows[index(v)]; };
  return name_of_edge(row(twin->from), row(twin->to)) +
         " has two triangles on one side: " +
         name_of_triangle({row(twin->from), row(twin->to), row(twin->third)}) + " and " +
         name_of_triangle({row(twin[1].from), row(twin[1].to), row(twin[1].third)});
}

// What is wrong at one arc of a ring, seen from its other end.
Defect find_arc_defect(const Adjacency& adjacency, Arc a, std::span<const Node> rows) {
  const Site w = adjacency.target(a);
  if (w < 0 || w >= adjacency.num_sites() || w == a.origin) {
    return "row " + std::to_string(rows[index(a.origin)]) +
           " has a neighbour that cannot be";
  }
  const std::string edge = name_of_edge(rows[index(a.origin)], rows[index(w)]);
  const Arc back = adjacency.reverse(a);
  const std::int32_t slot = back.index - adjacency.first_arc(w).index;
  if (back.origin != w || slot < 0 || slot >= adjacency.degree(w) ||
      adjacency.target(back) != a.origin || adjacency.reverse(back) != a) {
    return edge + " is not listed once at both ends";
  }
  if (!adjacency.has_left(a)) {
    const bool is_first = adjacency.is_boundary(w) && back == adjacency.first_arc(w);
    return is_first ? Defect() : edge + " is a boundary edge at one end only";
  }
  const Arc onward = adjacency.previous(back);
  if (adjacency.target(onward) != adjacency.target(adjacency.next(a)) ||
      !adjacency.has_left(onward)) {
    return edge + " has a triangle that its other end does not know";
  }
  return std::nullopt;
}

}  // namespace

std::string name_of_triangle(const Triple& rows) {
  return "triangle (" + std::to_string(rows[0]) + ", " + std::to_string(rows[1]) + ", " +
         std::to_string(rows[2]) + ")";
}

std::string name_of_edge(Node a, Node b) {
  return "edge (" + std::to_string(a) + ", " + std::to_string(b) + ")";
}

Defect find_ring_defect(const Adjacency& adjacency, std::span<const Node> rows) {
  for (Site v = 0; v < adjacency.num_sites(); ++v) {
    const std::string name = "row " + std::to_string(rows[index(v)]);
    const auto ring = adjacency.neighbors(v);
    if (ring.size() < (adjacency.is_boundary(v) ? 2u : 3u))
      return name + " is in no triangle";
    if (!adjacency.is_boundary(v) &&
        *std::min_element(ring.begin(), ring.end()) != ring[0]) {
      return "the list of " + name + " does not begin with its smallest neighbour";
    }
    Arc a = adjacency.first_arc(v);
    for (std::int32_t i = 0; i < adjacency.degree(v); ++i, a = adjacency.next(a)) {
      if (auto defect = find_arc_defect(adjacency, a, rows)) return defect;
    }
  }
  return std::nullopt;
}

Defect find_euler_defect(const Adjacency& adjacency) {
  const std::int64_t n = adjacency.num_sites();
  std::int64_t b = 0;
  for (Site v = 0; v < n; ++v) b += adjacency.is_boundary(v) ? 1 : 0;
  const std::int64_t triangles = b > 0 ? 2 * n - 2 - b : 2 * n - 4;
  const std::int64_t arcs = b > 0 ? 2 * (3 * n - 3 - b) : 2 * (3 * n - 6);
  if (adjacency.num_triangles() == triangles && adjacency.num_arcs() == arcs)
    return std::nullopt;
  return std::to_string(adjacency.num_triangles()) + " triangles and " +
         std::to_string(adjacency.num_arcs() / 2) + " edges, but " + std::to_string(n) +
         " points with " + std::to_string(b) + " on the boundary have " +
         std::to_string(triangles) + " and " + std::to_string(arcs / 2);
}

Defect find_map_defect(std::span<const Node> rows, std::span<const Site> sites) {
  std::vector<bool> is_seen(rows.size(), false);
  for (std::size_t r = 0; r < sites.size(); ++r) {
    const Site v = sites[r];
    if (v < 0 || index(v) >= rows.size()) {
      return "row " + std::to_string(r) + " belongs to no site";
    }
    if (!is_seen[index(v)] && rows[index(v)] != static_cast<Node>(r)) {
      return "row " + std::to_string(r) + " is the first of its position, but row " +
             std::to_string(rows[index(v)]) + " stands for it";
    }
    is_seen[index(v)] = true;
  }
  const auto unseen = std::find(is_seen.begin(), is_seen.end(), false);
  if (unseen == is_seen.end()) return std::nullopt;
  return "site " + std::to_string(unseen - is_seen.begin()) + " stands for no row";
}

Defect find_chain_defect(const Adjacency& adjacency, std::span<const Site> order,
                         Chain kind, std::span<const Node> rows) {
  const std::size_t n = order.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Site> expected;
    if (i > 0 || kind == Chain::closed) expected.push_back(order[(i + n - 1) % n]);
    if (i + 1 < n || kind == Chain::closed) expected.push_back(order[(i + 1) % n]);
    const auto ring = adjacency.neighbors(order[i]);
    if (!std::is_permutation(ring.begin(), ring.end(), expected.begin(),
                             expected.end())) {
      return "row " + std::to_string(rows[index(order[i])]) +
             " is not joined to its neighbours along the chain";
    }
  }
  return std::nullopt;
}

SiteTriangles site_triangles(std::span<const Triple> triangles,
                             const Positions& positions) {
  SiteTriangles result;
  result.triangles.reserve(triangles.size());
  for (const Triple& t : triangles) {
    Triple sites{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] < 0 || index(t[k]) >= positions.sites.size()) {
        result.defect = name_of_triangle(t) + " names row " + std::to_string(t[k]) +
                        ", but there are " + std::to_string(positions.sites.size());
        return result;
      }
      sites[k] = positions.sites[index(t[k])];
    }
    if (sites[0] == sites[1] || sites[1] == sites[2] || sites[2] == sites[0]) {
      result.defect = name_of_triangle(t) + " has two corners at one position";
      return result;
    }
    result.triangles.push_back(sites);
  }
  return result;
}

GluedTriangles glue(std::span<const Triple> triangles, std::span<const Node> rows) {
  const auto edges = sorted_half_edges(triangles);
  if (auto defect = find_twin(edges, rows)) return {{}, defect};
  std::vector<std::int32_t> offsets{0};
  std::vector<Site> neighbors;
  std::vector<bool> is_boundary;
  auto begin = edges.begin();
  for (Site v = 0; index(v) < rows.size(); ++v) {
    const auto end =
        std::find_if(begin, edges.end(), [&](const HalfEdge& e) { return e.from > v; });
    if (begin == end)
      return {{}, "row " + std::to_string(rows[index(v)]) + " is in no triangle"};
    const Fan fan = chain_fan({begin, end});
    if (!fan.is_whole) {
      return {{},
              "the triangles around row " + std::to_string(rows[index(v)]) +
                  " are not connected through edges"};
    }
    neighbors.insert(neighbors.end(), fan.ring.begin(), fan.ring.end());
    offsets.push_back(static_cast<std::int32_t>(neighbors.size()));
    is_boundary.push_back(fan.is_boundary);
    begin = end;
  }
  return {Adjacency(offsets, neighbors, is_boundary), {}};
}

}  // namespace delone::delaunay
