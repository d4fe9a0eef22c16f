#include "interp/smooth_factor.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "delaunay/parallel.hpp"
#include "interp/index.hpp"

namespace delone::interp {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double raised_diagonal = 1e-14;

/// Halves sets of sites.
class Dissector {
 public:
  explicit Dissector(const SmoothSystem& system)
      : system_(system), half_(at(system.num_sites()), 0) {}

  std::vector<EliminationFront> fronts() && {
    std::vector<Site> all(at(system_.num_sites()));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Site>(i);
    add(std::move(all));
    find_touched();
    return std::move(fronts_);
  }

 private:
  static constexpr std::size_t most_in_leaf = 12;
  struct Cut {
    std::vector<Site> first, second, between;
  };

  // Of a set, after those of its parts; its number.
  std::int32_t add(std::vector<Site> sites) {
    const auto first = static_cast<std::int32_t>(fronts_.size());
    std::vector<std::int32_t> children;
    if (sites.size() > most_in_leaf) {
      Cut cut = best_cut(sites);
      sites = std::move(cut.between);
      if (!cut.first.empty()) children.push_back(add(std::move(cut.first)));
      if (!cut.second.empty()) children.push_back(add(std::move(cut.second)));
    }
    const auto number = static_cast<std::int32_t>(fronts_.size());
    for (const std::int32_t c : children) fronts_[at(c)].parent = number;
    std::ranges::sort(sites);
    const auto num_own = static_cast<std::int32_t>(sites.size());
    fronts_.push_back({std::move(sites), num_own, none, std::move(children), first});
    return number;
  }

  Cut best_cut(const std::vector<Site>& sites) {
    Cut best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == 2 && !system_.is_trend_charged) break;  // the plane
      Cut cut = cut_across(sites, axis);
      if (axis == 0 || cut.between.size() < best.between.size()) best = std::move(cut);
    }
    return best;
  }

  Cut cut_across(std::vector<Site> sites, std::size_t axis) {
    const auto middle = sites.begin() + std::ssize(sites) / 2;
    std::ranges::nth_element(sites, middle, [&](Site a, Site b) {
      const double pa = system_.places[at(a)][axis], pb = system_.places[at(b)][axis];
      return pa != pb ? pa < pb : a < b;
    });
    const auto mark = [&](auto from, auto to, std::int8_t half) {
      for (; from != to; ++from) half_[at(*from)] = half;
    };
    mark(sites.begin(), middle, 1);
    mark(middle, sites.end(), 2);
    Cut cut;
    const auto part = [&](auto from, auto to, std::int8_t other) {
      std::pair<std::vector<Site>, std::vector<Site>> inner_and_edge;
      for (; from != to; ++from)
        (touches(*from, other) ? inner_and_edge.second : inner_and_edge.first)
            .push_back(*from);
      return inner_and_edge;
    };
    auto [first, first_edge] = part(sites.begin(), middle, 2);
    auto [second, second_edge] = part(middle, sites.end(), 1);
    mark(sites.begin(), sites.end(), 0);
    if (first_edge.size() <= second_edge.size()) {
      second.insert(second.end(), second_edge.begin(), second_edge.end());
      return {std::move(first), std::move(second), std::move(first_edge)};
    }
    first.insert(first.end(), first_edge.begin(), first_edge.end());
    return {std::move(first), std::move(second), std::move(second_edge)};
  }

  Site other_end(std::int32_t edge, Site s) const {
    const SmoothEdge& e = system_.edges[at(edge)];
    return e.first == s ? e.second : e.first;
  }

  bool touches(Site s, std::int8_t half) const {
    return std::ranges::any_of(system_.edges_of(s), [&](std::int32_t e) {
      return half_[at(other_end(e, s))] == half;
    });
  }

  void find_touched() {
    std::vector<std::int32_t> turn(half_.size());
    std::int32_t next = 0;
    for (const EliminationFront& f : fronts_)
      for (const Site s : f.sites) turn[at(s)] = next++;
    const auto is_earlier = [&](Site a, Site b) { return turn[at(a)] < turn[at(b)]; };
    for (EliminationFront& f : fronts_) {
      const std::vector<Site> own = f.sites;
      std::vector<Site> touched;
      for (const Site s : own)
        for (const std::int32_t e : system_.edges_of(s))
          touched.push_back(other_end(e, s));
      for (const std::int32_t c : f.children) {
        const EliminationFront& child = fronts_[at(c)];
        touched.insert(touched.end(), child.sites.begin() + child.num_own,
                       child.sites.end());
      }
      // Halves that do not touch leave a front without sites of its own.
      if (!own.empty())
        std::erase_if(touched, [&](Site s) { return !is_earlier(own.back(), s); });
      std::ranges::sort(touched, is_earlier);
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      f.sites.insert(f.sites.end(), touched.begin(), touched.end());
    }
  }

  const SmoothSystem& system_;
  std::vector<std::int8_t> half_;  ///< while a set is cut
  std::vector<EliminationFront> fronts_;
};

// Places of a front's touched sites in its parent.
std::vector<Index> places_in_parent(const EliminationFront& child,
                                    const EliminationFront& parent) {
  std::vector<Index> places;
  auto place = parent.sites.begin();
  for (auto s = child.sites.begin() + child.num_own; s != child.sites.end(); ++s) {
    while (*place != *s) ++place;  // both in the order of elimination
    places.push_back(place - parent.sites.begin());
  }
  return places;
}

// The lower triangle of a child's update.
void add_update(const MatrixXd& update, const std::vector<Index>& places,
                MatrixXd& matrix) {
  const auto count = std::ssize(places);
  for (Index j = 0; j < count; ++j)
    for (Index i = j; i < count; ++i)
      matrix.block<3, 3>(3 * places[at(i)], 3 * places[at(j)]) +=
          update.block<3, 3>(3 * i, 3 * j);
}

/// Factors the first `own` columns in place and leaves the update of the others.
void factor_front(MatrixXd& matrix, Index own) {
  const Index rest = matrix.rows() - own;
  const VectorXd diagonal = matrix.diagonal().head(own);
  const MatrixXd lower = matrix.topLeftCorner(own, own);
  double raise = raised_diagonal;
  for (;; raise *= 16) {
    matrix.topLeftCorner(own, own).diagonal() = diagonal * (1 + raise);
    Eigen::Ref<MatrixXd> square = matrix.topLeftCorner(own, own);
    const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(square);
    if (factor.info() == Eigen::Success || raise > 1) break;
    matrix.topLeftCorner(own, own) = lower;
  }
  if (rest == 0) return;
  auto below = matrix.bottomLeftCorner(rest, own);
  matrix.topLeftCorner(own, own)
      .triangularView<Eigen::Lower>()
      .transpose()
      .solveInPlace<Eigen::OnTheRight>(below);
  matrix.bottomRightCorner(rest, rest)
      .selfadjointView<Eigen::Lower>()
      .rankUpdate(below, -1);
}

MatrixXd gathered(const MatrixXd& from, const std::vector<Site>& sites) {
  MatrixXd rows(3 * std::ssize(sites), from.cols());
  for (std::size_t i = 0; i < sites.size(); ++i)
    rows.middleRows<3>(3 * static_cast<Index>(i)) =
        from.middleRows<3>(3 * Index{sites[i]});
  return rows;
}

void scatter(const MatrixXd& rows, const std::vector<Site>& sites, MatrixXd& to) {
  for (Index i = 0; i < rows.rows() / 3; ++i)
    to.middleRows<3>(3 * Index{sites[at(i)]}) = rows.middleRows<3>(3 * i);
}

MatrixXd blocks_at(const MatrixXd& from, const std::vector<Index>& places) {
  const auto count = std::ssize(places);
  MatrixXd result(3 * count, 3 * count);
  for (Index j = 0; j < count; ++j)
    for (Index i = 0; i < count; ++i)
      result.block<3, 3>(3 * i, 3 * j) =
          from.block<3, 3>(3 * places[at(i)], 3 * places[at(j)]);
  return result;
}

/// The inverse's part over a front, from its columns of the factor and the part over the
/// touched sites.
MatrixXd completed_inverse(const MatrixXd& columns, const MatrixXd& touched) {
  const Index own = columns.cols(), rest = touched.rows();
  if (own == 0) return touched;
  const auto top = columns.topRows(own).triangularView<Eigen::Lower>();
  MatrixXd root = MatrixXd::Identity(own, own);
  top.solveInPlace(root);
  if (rest == 0) return root.transpose() * root;
  MatrixXd ratio = columns.bottomRows(rest);
  top.solveInPlace<Eigen::OnTheRight>(ratio);
  MatrixXd inverse(own + rest, own + rest);
  inverse.bottomRightCorner(rest, rest) = touched;
  inverse.bottomLeftCorner(rest, own).noalias() = -touched * ratio;
  inverse.topRightCorner(own, rest) = inverse.bottomLeftCorner(rest, own).transpose();
  inverse.topLeftCorner(own, own) =
      root.transpose() * root - inverse.topRightCorner(own, rest) * ratio;
  return inverse;
}

// Subtrees that one thread does alone: those of at most `most` fronts.
std::vector<std::int32_t> small_subtrees(const std::vector<EliminationFront>& fronts,
                                         std::int32_t most) {
  std::vector<std::int32_t> roots;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(fronts.size()); ++f) {
    const auto size = [&](std::int32_t g) { return g - fronts[at(g)].first_below + 1; };
    const std::int32_t parent = fronts[at(f)].parent;
    if (size(f) <= most && (parent == none || size(parent) > most)) roots.push_back(f);
  }
  return roots;
}

}  // namespace

std::vector<EliminationFront> dissect(const SmoothSystem& system) {
  return Dissector(system).fronts();
}

SmoothFactor::SmoothFactor(const SmoothSystem& system,
                           const std::vector<EliminationFront>& fronts, double parameter,
                           const RunOptions& run)
    : system_(&system),
      fronts_(&fronts),
      parameter_(parameter),
      columns_(fronts.size()),
      updates_(fronts.size()) {
  const auto count = static_cast<std::int32_t>(fronts.size());
  const std::vector<std::int32_t> subtrees = small_subtrees(fronts, count / 12 + 1);
  std::vector<bool> is_done(fronts.size(), false);
  for (const std::int32_t root : subtrees)
    for (std::int32_t f = fronts[at(root)].first_below; f <= root; ++f)
      is_done[at(f)] = true;
  delaunay::parallel_chunks(std::ssize(subtrees), 1, run,
                            [&](std::int64_t first, std::int64_t) {
                              std::vector<std::int32_t> places(at(system.num_sites()));
                              const std::int32_t root = subtrees[at(first)];
                              for (std::int32_t f = fronts[at(root)].first_below;
                                   f <= root; ++f)
                                eliminate(f, places);
                            },
                            {0, 0.5});
  std::vector<std::int32_t> places(at(system.num_sites()));
  for (std::int32_t f = 0; f < count; ++f)
    if (!is_done[at(f)]) eliminate(f, places);
}

void SmoothFactor::eliminate(std::int32_t number, std::vector<std::int32_t>& places) {
  const EliminationFront& front = (*fronts_)[at(number)];
  const Index size = 3 * std::ssize(front.sites), own = 3 * Index{front.num_own};
  MatrixXd matrix = MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < front.sites.size(); ++i)
    places[at(front.sites[i])] = static_cast<std::int32_t>(i);
  assemble(number, places, matrix);
  for (const std::int32_t c : front.children) {
    add_update(updates_[at(c)], places_in_parent((*fronts_)[at(c)], front), matrix);
    updates_[at(c)] = MatrixXd();
  }
  if (own > 0) factor_front(matrix, own);
  columns_[at(number)] = matrix.leftCols(own);
  updates_[at(number)] = matrix.bottomRightCorner(size - own, size - own);
}

void SmoothFactor::assemble(std::int32_t number, const std::vector<std::int32_t>& places,
                            MatrixXd& matrix) const {
  const EliminationFront& front = (*fronts_)[at(number)];
  for (Index i = 0; i < front.num_own; ++i) {
    const Site s = front.sites[at(i)];
    matrix(3 * i, 3 * i) += system_->weights[s];
    for (const std::int32_t number_of_edge : system_->edges_of(s)) {
      const SmoothEdge& e = system_->edges[at(number_of_edge)];
      const Eigen::Matrix<double, 6, 6> part = parameter_ * edge_matrix(e);
      const bool is_first = e.first == s;
      const Site other = is_first ? e.second : e.first;
      matrix.block<3, 3>(3 * i, 3 * i) +=
          is_first ? part.topLeftCorner<3, 3>() : part.bottomRightCorner<3, 3>();
      // Eliminated before: already taken along.
      const Index j = places[at(other)];
      if (j <= i || j >= std::ssize(front.sites) || front.sites[at(j)] != other) continue;
      matrix.block<3, 3>(3 * j, 3 * i) +=
          is_first ? part.bottomLeftCorner<3, 3>() : part.topRightCorner<3, 3>();
    }
  }
}

MatrixXd SmoothFactor::solve(MatrixXd right) const {
  const std::vector<EliminationFront>& fronts = *fronts_;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const Index own = columns_[f].cols(), rest = columns_[f].rows() - own;
    if (own == 0) continue;
    MatrixXd rows = gathered(right, fronts[f].sites);
    auto top = rows.topRows(own);
    columns_[f].topRows(own).triangularView<Eigen::Lower>().solveInPlace(top);
    rows.bottomRows(rest).noalias() -= columns_[f].bottomRows(rest) * top;
    scatter(rows, fronts[f].sites, right);
  }
  for (std::size_t f = fronts.size(); f-- > 0;) {
    const Index own = columns_[f].cols(), rest = columns_[f].rows() - own;
    if (own == 0) continue;
    MatrixXd rows = gathered(right, fronts[f].sites);
    auto top = rows.topRows(own);
    top.noalias() -= columns_[f].bottomRows(rest).transpose() * rows.bottomRows(rest);
    columns_[f].topRows(own).triangularView<Eigen::Lower>().transpose().solveInPlace(top);
    scatter(top, fronts[f].sites, right);
  }
  return right;
}

VectorXd SmoothFactor::refined(const VectorXd& right) const {
  constexpr int most_steps = 60;
  constexpr double tolerance = 1e-26;  // of the squared norm
  VectorXd x = VectorXd::Zero(right.size()), residual = right;
  VectorXd better = solve(residual), step = better;
  double size = residual.dot(better);
  const double first_size = size;
  for (int k = 0; k < most_steps && size > tolerance * first_size; ++k) {
    const VectorXd image = system_->apply(parameter_, step);
    const double energy = step.dot(image);
    if (!(energy > 0)) break;
    x += (size / energy) * step;
    residual -= (size / energy) * image;
    better = solve(residual);
    const double next_size = residual.dot(better);
    step = better + (next_size / size) * step;
    size = next_size;
  }
  return x;
}

VectorXd SmoothFactor::inverse_diagonal() const {
  const std::vector<EliminationFront>& fronts = *fronts_;
  std::vector<MatrixXd> inverses(fronts.size());
  VectorXd diagonal(system_->num_sites());
  for (std::size_t f = fronts.size(); f-- > 0;) {
    const EliminationFront& front = fronts[f];
    MatrixXd touched;
    if (front.parent != none) {
      const EliminationFront& parent = fronts[at(front.parent)];
      MatrixXd& above = inverses[at(front.parent)];
      touched = blocks_at(above, places_in_parent(front, parent));
      const bool is_last_to_ask = parent.children.front() == static_cast<std::int32_t>(f);
      if (is_last_to_ask) above = MatrixXd();
    }
    MatrixXd inverse = completed_inverse(columns_[f], touched);
    for (Index i = 0; i < front.num_own; ++i)
      diagonal[front.sites[at(i)]] = inverse(3 * i, 3 * i);
    if (!front.children.empty()) inverses[f] = std::move(inverse);
  }
  return diagonal;
}

}  // namespace delone::interp
