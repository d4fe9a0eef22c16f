#include "delaunay/locate_batch.hpp"

namespace delone::delaunay {

namespace {

struct NumberedTriangle {
  std::array<Node, 3> rows;
  Arc arc;
};

/// Triangles by their smallest row.
class TrianglesOfSites {
 public:
  TrianglesOfSites(const Adjacency& t, std::span<const Node> rows) : t_(t), rows_(rows) {}

  /// Those whose smallest row is v's, sorted as Triangulation::triangles() has them;
  /// valid until the next call.
  [[nodiscard]] std::span<const NumberedTriangle> from(Site v) {
    found_.clear();
    Arc a = t_.first_arc(v);
    for (std::int32_t i = 0; i < t_.degree(v); ++i, a = t_.next(a)) {
      if (!t_.has_left(a)) continue;
      const auto [first, second, third] = t_.left(a);
      if (row(second) > row(first) && row(third) > row(first))
        found_.push_back({{row(first), row(second), row(third)}, a});
    }
    std::ranges::sort(found_, {}, &NumberedTriangle::rows);
    return found_;
  }

 private:
  [[nodiscard]] Node row(Site s) const { return rows_[static_cast<std::size_t>(s)]; }

  const Adjacency& t_;
  std::span<const Node> rows_;
  std::vector<NumberedTriangle> found_;
};

}  // namespace

// Twice over the sites, first to count: in the order of rows every step would miss the
// cache.
std::vector<std::int32_t> triangle_numbers(const Adjacency& t, std::span<const Node> rows,
                                           std::span<const Site> sites) {
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(t.num_arcs()), none);
  if (t.is_chain()) return numbers;
  TrianglesOfSites triangles(t, rows);
  std::vector<std::int32_t> first(sites.size() + 1, 0);
  for (Site v = 0; v < t.num_sites(); ++v) {
    const auto row = static_cast<std::size_t>(rows[static_cast<std::size_t>(v)]);
    first[row + 1] = static_cast<std::int32_t>(triangles.from(v).size());
  }
  for (std::size_t row = 0; row < sites.size(); ++row) first[row + 1] += first[row];
  for (Site v = 0; v < t.num_sites(); ++v) {
    const auto row = static_cast<std::size_t>(rows[static_cast<std::size_t>(v)]);
    std::int32_t number = first[row];
    for (const NumberedTriangle& triangle : triangles.from(v)) {
      const Arc a = triangle.arc;
      for (const Arc side : {a, t.previous(t.reverse(a)), t.reverse(t.next(a))})
        numbers[static_cast<std::size_t>(side.index)] = number;
      ++number;
    }
  }
  return numbers;
}

Location named_from_smallest(Location location) {
  using Kind = Location::Kind;
  const auto begin = location.nodes.begin();
  const auto size = location.kind == Kind::edge       ? 2
                    : location.kind == Kind::triangle ? 3
                                                      : 0;
  std::rotate(begin, std::min_element(begin, begin + size), begin + size);
  return location;
}

}  // namespace delone::delaunay
