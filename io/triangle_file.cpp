#include "io/triangle_file.hpp"

#include <algorithm>
#include <string_view>

#include "delaunay/error.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

using delaunay::SideOrder;
using delaunay::triangle_neighbors;

void append_corners(TextWriter& text, const Triangle& t, int base) {
  text << t[0] + base << ' ' << t[1] + base << ' ' << t[2] + base << '\n';
}

/// An edge, and whether one triangle has it or two.
struct CountedEdge {
  std::int32_t low = 0, high = 0;
  int num_triangles = 0;
};

std::vector<CountedEdge> counted_edges(std::span<const Triangle> triangles) {
  std::vector<std::array<std::int32_t, 2>> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({low, high});
    }
  }
  std::ranges::sort(sides);
  std::vector<CountedEdge> edges;
  for (const auto& [low, high] : sides) {
    const bool is_known =
        !edges.empty() && edges.back().low == low && edges.back().high == high;
    if (!is_known) edges.push_back({low, high, 0});
    ++edges.back().num_triangles;
  }
  return edges;
}

void require_as_many(std::size_t num_nodes, std::size_t num_lists) {
  if (num_nodes == num_lists) return;
  throw Error("neighbours: " + std::to_string(num_nodes) + " nodes and " +
              std::to_string(num_lists) + " lists of neighbours; give one list a node");
}

}  // namespace

void write_tri(const std::string& path, std::span<const Triangle> triangles, int base) {
  TextWriter text(path);
  for (const Triangle& triangle : triangles) append_corners(text, triangle, base);
  text.commit();
}

void write_ele(const std::string& path, std::span<const Triangle> triangles, int base) {
  TextWriter text(path);
  text << triangles.size() << " 3 0\n";
  std::int64_t number = base;
  for (const Triangle& triangle : triangles) {
    text << number++ << ' ';
    append_corners(text, triangle, base);
  }
  text.commit();
}

void write_neigh(const std::string& path, std::span<const Triangle> triangles, int base) {
  const auto shown = [base](std::int32_t triangle) {
    return triangle < 0 ? -1 : triangle + base;
  };
  TextWriter text(path);
  text << triangles.size() << " 3\n";
  std::int64_t number = base;
  for (const auto& [a, b, c] : triangle_neighbors(triangles, SideOrder::opposite_corner))
    text << number++ << ' ' << shown(a) << ' ' << shown(b) << ' ' << shown(c) << '\n';
  text.commit();
}

void write_edge(const std::string& path, std::span<const Triangle> triangles, int base) {
  const std::vector<CountedEdge> edges = counted_edges(triangles);
  TextWriter text(path);
  text << edges.size() << " 1\n";
  std::int64_t number = base;
  for (const auto& [low, high, num_triangles] : edges)
    text << number++ << ' ' << low + base << ' ' << high + base << ' '
         << (num_triangles == 1 ? 1 : 0) << '\n';
  text.commit();
}

void write_adj(const std::string& path, std::span<const std::int32_t> nodes,
               const std::vector<std::vector<std::int32_t>>& lists, int base) {
  require_as_many(nodes.size(), lists.size());
  TextWriter text(path);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    text << nodes[i] + base;
    for (const std::int32_t neighbour : lists[i]) text << ' ' << neighbour + base;
    text << '\n';
  }
  text.commit();
}

void write_mathematica(const std::string& path, std::span<const std::int32_t> nodes,
                       const std::vector<std::vector<std::int32_t>>& lists, int base) {
  require_as_many(nodes.size(), lists.size());
  TextWriter text(path);
  text << '{';
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    text << (i == 0 ? "{" : ",\n {") << nodes[i] + base << ", {";
    for (std::size_t k = 0; k < lists[i].size(); ++k)
      text << (k == 0 ? "" : ", ") << lists[i][k] + base;
    text << "}}";
  }
  text << "}\n";
  text.commit();
}

void write_qhull_i(const std::string& path, std::span<const Triangle> triangles) {
  TextWriter text(path);
  text << triangles.size() << '\n';
  for (const Triangle& triangle : triangles) append_corners(text, triangle, 0);
  text.commit();
}

void write_qhull_fv(const std::string& path, std::span<const Triangle> triangles) {
  TextWriter text(path);
  text << triangles.size() << '\n';
  for (const Triangle& triangle : triangles) {
    text << "3 ";
    append_corners(text, triangle, 0);
  }
  text.commit();
}

void write_qhull_fn(const std::string& path, std::span<const Triangle> triangles,
                    std::int64_t num_nodes) {
  std::vector<std::vector<std::int32_t>> triangles_at(
      static_cast<std::size_t>(num_nodes));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const std::int32_t corner : triangles[t])
      triangles_at.at(static_cast<std::size_t>(corner))
          .push_back(static_cast<std::int32_t>(t));
  TextWriter text(path);
  text << num_nodes << '\n';
  for (const auto& list : triangles_at) {
    text << list.size();
    for (const std::int32_t triangle : list) text << ' ' << triangle;
    text << '\n';
  }
  text.commit();
}

void write_v_edge(const std::string& path, const EdgeFile& file) {
  TextWriter text(path);
  text << file.edges.size() << " 0\n";
  std::int64_t number = file.base;
  for (const auto& [from, to, dx, dy, marker] : file.edges) {
    text << number++ << ' ' << from + file.base << ' ';
    if (to < 0)
      text << "-1 " << dx << ' ' << dy << '\n';
    else
      text << to + file.base << '\n';
  }
  text.commit();
}

}  // namespace delone::io
