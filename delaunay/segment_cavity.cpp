#include "delaunay/segment_cavity.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace delone::delaunay {

namespace {

// From v to w; its index is none if there is none. Looked for at the end with fewer.
Arc find_arc(const Adjacency& lists, Site v, Site w) {
  if (lists.degree(w) < lists.degree(v)) {
    const Arc back = find_arc(lists, w, v);
    return back.index == none ? back : lists.reverse(back);
  }
  const auto neighbors = lists.neighbors(v);
  const auto found = std::find(neighbors.begin(), neighbors.end(), w);
  if (found == neighbors.end()) return {v, none};
  return {
      v, lists.first_arc(v).index + static_cast<std::int32_t>(found - neighbors.begin())};
}

}  // namespace

void CavitySide::reverse() {
  std::reverse(node_.begin(), node_.end());
  std::reverse(inner_.begin(), inner_.end());
}

void CavitySide::look_around(const ClosedMesh& mesh) {
  around_.clear();
  bool has_tip = false;  // an edge that sticks into the cavity ends in one
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    const HalfEdge e = inner_[i];
    around_.push_back({mesh.reverse(e), none, mesh.is_constraint(e)});
    has_tip = has_tip || (i > 0 && node_[i - 1] == node_[i + 1]);
  }
  if (has_tip) match_doubled_edges();
}

void CavitySide::match_doubled_edges() {
  std::unordered_map<HalfEdge, std::size_t> side_of;
  for (std::size_t i = 0; i < inner_.size(); ++i) side_of.emplace(inner_[i], i);
  for (Around& around : around_) {
    const auto found = side_of.find(around.outer);
    if (found != side_of.end()) around.partner = found->second;
  }
}

void CavitySide::attach(ClosedMesh& mesh, std::size_t side, HalfEdge edge) {
  Around& around = around_[side];
  around.filled = edge;
  if (around.partner != no_partner) around.outer = around_[around.partner].filled;
  if (around.partner != no_partner && around.outer == none) return;
  mesh.join(edge, around.outer);
  if (around.is_constraint) mesh.set_constraint(edge, Constraint::on);
}

HalfEdge CavitySide::fill_planned(ClosedMesh& mesh) {
  HalfEdge base = none;
  parts_.assign(1, {0, node_.size() - 1, none});
  auto apex = apexes_.begin();
  while (!parts_.empty()) {
    const Part part = parts_.back();
    parts_.pop_back();
    if (part.last - part.first == 1) {
      attach(mesh, part.first, part.edge);
      continue;
    }
    const std::int32_t f =
        mesh.add_face({node_[part.last], node_[part.first], node_[*apex]});
    if (part.edge == none) {
      base = ClosedMesh::half_edge(f, 0);
    } else {
      mesh.join(part.edge, ClosedMesh::half_edge(f, 0));
    }
    parts_.push_back({part.first, *apex, ClosedMesh::half_edge(f, 1)});
    parts_.push_back({*apex, part.last, ClosedMesh::half_edge(f, 2)});
    ++apex;
  }
  return base;
}

std::vector<Site> CavitySide::distinct_nodes() const {
  std::vector<Site> nodes = node_;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// The triangles between the segment and the sides: from the segment on across all edges
// that are no sides. False if one of these is no edge of `t`, or what lies between is not
// all triangles.
bool CavitySide::find_among(const PartialTriangulation& t) {
  const Adjacency& lists = t.adjacency;
  std::unordered_map<Site, Site> local;
  for (std::size_t i = 0; i < t.sites.size(); ++i)
    local.emplace(t.sites[i], static_cast<Site>(i));
  const auto find = [&](Site v, Site w) {
    return find_arc(lists, local.at(v), local.at(w));
  };
  std::unordered_map<std::int32_t, std::ptrdiff_t> side_at;  // by arc
  for (std::size_t i = 0; i + 1 < node_.size(); ++i) {
    const Arc side = find(node_[i], node_[i + 1]);
    if (side.index == none) return false;
    side_at.emplace(side.index, static_cast<std::ptrdiff_t>(i));
  }
  const Arc base = find(node_.back(), node_.front());
  if (base.index == none) return false;
  struct Entry {
    Arc arc;                // with the face on its left
    std::ptrdiff_t parent;  // the edge it is come through
  };
  std::vector<Entry> ahead{{base, none}};
  found_.clear();
  while (!ahead.empty()) {
    const auto [arc, parent] = ahead.back();
    ahead.pop_back();
    if (!lists.has_left(arc) || found_.size() + 2 == node_.size()) return false;
    const auto f = static_cast<std::ptrdiff_t>(found_.size());
    const std::array<Site, 3> corner = lists.left(arc);
    FoundFace face{{}, {~parent, none, none}};
    for (std::size_t k = 0; k < 3; ++k)
      face.node[k] = t.sites[static_cast<std::size_t>(corner[k])];
    const Arc after = lists.previous(lists.reverse(arc));
    const Arc before = lists.reverse(lists.next(arc));
    for (const auto& [side, k] : {std::pair(after, 1), std::pair(before, 2)}) {
      const auto found = side_at.find(side.index);
      if (found != side_at.end()) {
        face.edge[static_cast<std::size_t>(k)] = found->second;
      } else {
        ahead.push_back({lists.reverse(side), 4 * f + k});
      }
    }
    found_.push_back(face);
  }
  return found_.size() + 2 == node_.size();
}

HalfEdge CavitySide::fill_found(ClosedMesh& mesh) {
  std::vector<std::int32_t> faces;
  for (const FoundFace& face : found_) {
    const std::int32_t f = mesh.add_face(face.node);
    faces.push_back(f);
    const std::ptrdiff_t parent = ~face.edge[0];
    if (parent != none) {
      mesh.join(ClosedMesh::half_edge(f, 0),
                ClosedMesh::half_edge(faces[static_cast<std::size_t>(parent / 4)],
                                      static_cast<std::size_t>(parent % 4)));
    }
    for (const std::size_t k : {1U, 2U}) {
      if (face.edge[k] != none)
        attach(mesh, static_cast<std::size_t>(face.edge[k]), ClosedMesh::half_edge(f, k));
    }
  }
  return ClosedMesh::half_edge(faces.front(), 0);
}

}  // namespace delone::delaunay
