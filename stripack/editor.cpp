#include "stripack/editor.hpp"

#include <span>
#include <utility>

#include "delaunay/editable_set.hpp"
#include "stripack/constrained_builder.hpp"
#include "stripack/sphere_editing.hpp"

namespace delone::stripack {

struct Editor::State {
  delaunay::EditableSet<SphereEditing> set;
};

Editor::Editor() : state_(std::make_unique<State>()) {}
Editor::Editor(const Triangulation& t)
    : state_(std::make_unique<State>(State{delaunay::EditableSet<SphereEditing>(t)})) {}
Editor::Editor(const Editor& other) : state_(std::make_unique<State>(*other.state_)) {}
Editor::Editor(Editor&& other) noexcept = default;
Editor& Editor::operator=(const Editor& other) {
  *state_ = *other.state_;
  return *this;
}
Editor& Editor::operator=(Editor&& other) noexcept = default;
Editor::~Editor() = default;

Node Editor::insert(const Direction& p, Node hint) { return state_->set.insert(p, hint); }
void Editor::remove(Node row) { state_->set.remove(row); }
void Editor::move(Node row, const Direction& p) { state_->set.move(row, p); }

void Editor::force_arc(Node a, Node b) { state_->set.force(a, b); }
void Editor::release_arc(Node a, Node b) { state_->set.release(a, b); }
bool Editor::is_forced(Node a, Node b) const noexcept {
  return state_->set.is_forced(a, b);
}
std::vector<std::array<Node, 2>> Editor::arcs() const { return state_->set.arcs(); }

Node Editor::num_rows() const noexcept { return state_->set.num_rows(); }
Node Editor::num_points() const noexcept { return state_->set.num_points(); }
Site Editor::num_sites() const noexcept { return state_->set.num_sites(); }
bool Editor::has(Node row) const noexcept { return state_->set.has(row); }
Direction Editor::point(Node row) const { return state_->set.point(row); }
std::vector<Node> Editor::rows() const { return state_->set.rows(); }
std::vector<Direction> Editor::points() const { return state_->set.points(); }

Triangulation Editor::triangulation() const {
  const auto& set = state_->set;
  return {set.points(), RunOptions{},
          [&](std::span<const Node> first) { return set.adjacency(set.rows(), first); }};
}

// Segments then find their edges in place.
ConstrainedTriangulation Editor::constrained_triangulation(
    const SphereConstraintOptions& options) const {
  const auto& set = state_->set;
  const std::vector<Node> live = set.rows();
  std::vector<Node> place(static_cast<std::size_t>(set.num_rows()), delaunay::none);
  for (std::size_t i = 0; i < live.size(); ++i)
    place[static_cast<std::size_t>(live[i])] = static_cast<Node>(i);
  SphereGraph graph{.points = set.points()};
  for (const auto& [a, b] : set.arcs())
    graph.arcs.push_back(
        {place[static_cast<std::size_t>(a)], place[static_cast<std::size_t>(b)]});
  const Triangulation forced(
      graph.points, RunOptions{},
      [&](std::span<const Node> first) { return set.forced_adjacency(live, first); });
  return ConstraintBuilder(graph, options, forced).finish();
}

}  // namespace delone::stripack
