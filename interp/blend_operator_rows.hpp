#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "interp/blend_cells.hpp"
#include "interp/blend_hump.hpp"
#include "interp/blend_operator_facet.hpp"
#include "interp/blend_operator_node.hpp"
#include "interp/operator_terms.hpp"

namespace delone::interp {

inline PlaneSpace blend_space_of(const PlaneCells& cells) { return {cells.scale()}; }
inline SphereSpace blend_space_of(const SphereCells&) { return {}; }

/// What a, b and c of an edge's hump take from what the edge lies between; the smaller
/// site is the first.
template <int Degree>
struct HumpShares {
  using Parts = std::array<double, num_blend_terms(Degree)>;
  double rise = 0;          ///< from the value of the first site to that of the second
  Parts first{}, second{};  ///< coefficients
};

/// A sum over coefficients of a node and over the rise to another.
template <int Degree>
using CoefficientWeights = std::array<double, num_blend_terms(Degree)>;

/// Rows of the operator of a blended surface with fixed choices, in one chunk of targets.
/// Remembers the nodes and edges it met.
///
/// The columns are the sites; with choices for gradients that are known, three a site:
/// its value, and its gradient by scaled length along the axes of the node.
template <BlendSpace Space, int Degree>
class BlendRows {
 public:
  using Triangulation = typename Space::Triangulation;
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Linear = typename LinearCellsOf<Space>::Type;

  BlendRows(const Linear& linear, const C1Choices& choices)
      : linear_(&linear),
        space_(blend_space_of(linear)),
        choices_(&choices),
        num_columns_(choices.gradients == Gradients::local ? 1 : 3),
        gatherer_(space_, linear.triangulation()) {}

  /// Good until the next call.
  [[nodiscard]] const NodalTerms& operator()(const Point& p, Cursor& cursor) {
    row_.clear();
    const Triangulation& t = linear_->triangulation();
    if (!is_finite(p) || t.dimension() < 2) return take(linear_->combination(p, cursor));
    const Spot spot = find_spot(t, p, cursor.arc);
    if (spot.kind == Spot::Kind::outside) {
      if (linear_->options().outside == Outside::linear) return continued(p, cursor);
      return take(linear_->combination(p, cursor));
    }
    if (!linear_->is_reached(p, spot, cursor)) return row_;
    if (spot.kind == Spot::Kind::node) {
      row_.add(value_of(spot.sites[0]), 1);
      return row_;
    }
    const std::array<Site, 3> corners = smallest_triangle(t.adjacency(), spot).sites;
    const auto weights = weights_of(corners);
    const Vector at = space_.vector(p);
    return take(corners, at, weights(at));
  }

 private:
  using Node = BlendNode<Degree>;
  using Coefficients = CoefficientWeights<Degree>;

  // The column of a site's value.
  [[nodiscard]] Site value_of(Site s) const noexcept { return num_columns_ * s; }

  const NodalTerms& take(const Combination& linear) {
    for (std::size_t k = 0; k < linear.sites().size(); ++k)
      row_.add(value_of(linear.sites()[k]), linear.weights()[k]);
    return row_;
  }

  // As BlendCells continues the surface.
  const NodalTerms& continued(const Point& p, Cursor& cursor) {
    if constexpr (std::same_as<Space, PlaneSpace>) {
      const Triangulation& t = linear_->triangulation();
      if (linear_->reach().is_limited()) {
        cursor.site = nearest_site(t, p, cursor.site);
        if (!linear_->reach().covers(p, cursor.site)) return row_;
      }
      const Vector at = space_.vector(p);
      const Arc inner =
          t.adjacency().reverse(linear_->extension().zone(at, cursor.arc).after);
      const std::array<Site, 3> corners = smallest_first(t.adjacency().left(inner));
      const auto first = std::find(corners.begin(), corners.end(), inner.origin);
      return take(corners, at,
                  weights_of(corners).beyond_edge(
                      static_cast<std::size_t>(first - corners.begin()), at));
    } else {
      return row_;
    }
  }

  [[nodiscard]] Vector vector_of(Site s) const {
    return space_.vector(linear_->triangulation().points()[at(s)]);
  }
  [[nodiscard]] BlendWeights<Space> weights_of(const std::array<Site, 3>& corners) {
    std::array<Vector, 3> points;
    std::array<double, 3> tensions{};
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = vector_of(corners[k]);
      tensions[k] = node(corners[k]).tension;
    }
    return {points, tensions};
  }

  // All is relative to the values of nodes, so that the weights sum to one.
  const NodalTerms& take(const std::array<Site, 3>& corners, const Vector& p,
                         const BlendShares& shares) {
    std::array<Coefficients, 3> coefficients{};
    for (std::size_t k = 0; k < 3; ++k)
      add_terms(coefficients[k], corners[k], p, shares.polynomials[k]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      add_hump(corners[k], corners[next], shares.humps[k], coefficients[k],
               coefficients[next]);
    }
    row_.add(value_of(corners[0]), 1);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0)
        row_.add_rise(value_of(corners[0]), value_of(corners[k]),
                      shares.polynomials[k] + shares.values[k]);
      add_node(corners[k], coefficients[k]);
    }
    return row_;
  }

  void add_terms(Coefficients& sum, Site s, const Vector& p, double part) {
    const Vector center = vector_of(s);
    const auto terms = model_terms<Degree>(
        Space::local(Space::axes(center), Space::position(Space::difference(p, center)),
                     node(s).per_radius));
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += part * terms[c];
  }

  void add_node(Site s, const Coefficients& coefficients) {
    const Node& n = node(s);
    rises_.assign(n.sites.size(), 0);
    for (std::size_t c = 0; c < coefficients.size() && !n.weights.empty(); ++c) {
      const double* const weights = n.weights_of(c);
      for (std::size_t k = 0; k < rises_.size(); ++k)
        rises_[k] += coefficients[c] * weights[k];
    }
    double sum = 0;
    for (std::size_t k = 0; k < rises_.size(); ++k) {
      row_.add(value_of(n.sites[k]), rises_[k]);
      sum += rises_[k];
    }
    row_.add(value_of(s), -sum);
    if (!n.places.empty()) add_gradient(s, n, {coefficients[0], coefficients[1]});
  }

  // The rises are those above the gradient.
  void add_gradient(Site s, const Node& n, std::array<double, 2> parts) {
    for (std::size_t i = 0; i < 2; ++i) {
      parts[i] *= n.gradient_part;
      for (std::size_t k = 0; k < rises_.size(); ++k)
        parts[i] -= rises_[k] * n.places[k][i];
      row_.add(value_of(s) + 1 + static_cast<Site>(i), parts[i] / n.per_radius);
    }
  }

  // `parts`: of a, b and c of the hump from one end to the other, which turns the sign of
  // b if that is not from the smaller site to the larger.
  void add_hump(Site from, Site to, std::array<double, 3> parts, Coefficients& at_from,
                Coefficients& at_to) {
    if (parts[0] == 0) return;
    if (from > to) {
      parts[1] = -parts[1];
      return add_hump_along(to, from, parts, at_to, at_from);
    }
    add_hump_along(from, to, parts, at_from, at_to);
  }
  void add_hump_along(Site first, Site second, const std::array<double, 3>& parts,
                      Coefficients& at_first, Coefficients& at_second) {
    const auto& shares = hump(first, second);
    for (std::size_t i = 0; i < 3; ++i) {
      row_.add_rise(value_of(first), value_of(second), parts[i] * shares[i].rise);
      for (std::size_t c = 0; c < at_first.size(); ++c) {
        at_first[c] += parts[i] * shares[i].first[c];
        at_second[c] += parts[i] * shares[i].second[c];
      }
    }
  }

  const Node& node(Site s) {
    const auto found = nodes_.find(s);
    if (found != nodes_.end()) return found->second;
    return nodes_
        .emplace(s,
                 blend_node<Space, Degree>(space_, linear_->triangulation(), s,
                                           gatherer_.around(s, num_nearest(Degree)),
                                           choices_->nodes[at(s)], choices_->gradients))
        .first->second;
  }

  using Hump = std::array<HumpShares<Degree>, 3>;  // of a, b and c

  const Hump& hump(Site first, Site second) {
    const auto key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(first)) << 32 |
                     static_cast<std::uint32_t>(second);
    const auto found = humps_.find(key);
    if (found != humps_.end()) return found->second;
    return humps_.emplace(key, make_hump(first, second)).first->second;
  }

  // The hump is linear in the models: one of each at a time.
  Hump make_hump(Site first, Site second) {
    const Vector a = vector_of(first), b = vector_of(second);
    BlendModel<Degree> one = empty_model(node(first)), other = empty_model(node(second));
    Hump result;
    const auto store = [&](auto part) {
      const EdgeHump h = edge_hump<Space, Degree>(
          a, b, one, other, std::numeric_limits<double>::infinity());
      part(result[0]) = h.a;
      part(result[1]) = h.b;
      part(result[2]) = h.c;
    };
    other.value = 1;
    store([](auto& shares) -> double& { return shares.rise; });
    other.value = 0;
    for (std::size_t c = 0; c < one.coefficients.size(); ++c) {
      one.coefficients[c] = 1;
      store([c](auto& shares) -> double& { return shares.first[c]; });
      one.coefficients[c] = 0;
      other.coefficients[c] = 1;
      store([c](auto& shares) -> double& { return shares.second[c]; });
      other.coefficients[c] = 0;
    }
    return result;
  }
  static BlendModel<Degree> empty_model(const Node& node) {
    BlendModel<Degree> model;
    model.per_radius = node.per_radius;
    model.tension = node.tension;
    model.least = -std::numeric_limits<double>::infinity();
    model.most = std::numeric_limits<double>::infinity();
    return model;
  }

  const Linear* linear_;
  Space space_;
  const C1Choices* choices_;
  Site num_columns_;  ///< a site
  StencilGatherer<Space> gatherer_;
  std::unordered_map<Site, Node> nodes_;
  std::unordered_map<std::uint64_t, Hump> humps_;
  NodalTerms row_;
  std::vector<double> rises_;
};

}  // namespace delone::interp
