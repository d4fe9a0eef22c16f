#include "delaunay/segment_cavity.hpp"

#include <algorithm>
#include <unordered_map>

namespace delone::delaunay {

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

}  // namespace delone::delaunay
