#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "interp/blend_space.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

/// An edge of a smoothing surface. Gradients have two components along axes of their node
/// (Space::axes); the tangents are the edge's directions in them.
struct SmoothEdge {
  Site first = none, second = none;
  std::array<double, 2> tangent_first{}, tangent_second{};
  double length = 0;
  double bend = 0;  ///< weight of the squared change of the gradient
  double pull = 0;  ///< weight of (rise - length * mean slope)^2
  /// Of a chain, whose slopes across itself nothing else determines: weight of their
  /// squared sum.
  double across = 0;
};

/// The roughness of a surface that has a value and a gradient at every node.
///
/// The sum over edges of c (|change of the gradient|^2 + 12 (rise / length - mean
/// slope)^2): with the along-edge parts of both, the length times the integral of the
/// squared second derivative of the edge's Hermite cubic. c is half the sum of the
/// cotangents of the angles across the edge. These weights give sum c e e^T = area * I
/// over a triangle, so that the sum is the integral of fxx^2 + 2 fxy^2 + fyy^2 exactly
/// for quadratic functions on every Delaunay triangulation, whose sums of cotangents are
/// never negative; it depends neither on the density of the nodes nor on how cocircular
/// ones are joined. Slivers at the hull get at most `most_bend` times the weight
/// that their area gives them: else they would force gradients to be equal.
///
/// Linear functions in the plane and constants on the sphere cost nothing. `trend` holds
/// the functions that are to cost nothing besides constants: in the plane the
/// coordinates, on the sphere the first-degree harmonics, which are_charged by the sum.
/// Collinear nodes: the integral of the squared second derivative along the chain.
///
/// Coordinates are divided by the domain's extent, a power of two. Unknowns: 3 s the
/// value, 3 s + 1 and 3 s + 2 the gradient of site s.
struct SmoothSystem {
  std::vector<SmoothEdge> edges;
  /// Edges of every site: edge_lists[offsets[s]] .. edge_lists[offsets[s + 1] - 1].
  std::vector<std::int32_t> offsets, edge_lists;
  std::vector<std::array<double, 3>> places;  ///< of the sites, from the first one
  Eigen::VectorXd weights;                    ///< of the values; their mean is 1
  Eigen::MatrixXd trend;                      ///< unknowns of every trend function
  bool is_trend_charged = false;
  bool is_chain = false;    ///< collinear
  double scale = 1;         ///< coordinates were multiplied by this
  double extent_scale = 1;  ///< the part of it that is beside the scale of the space
  double area = 0;          ///< of the triangles (of a chain, its length), scaled

  [[nodiscard]] std::int32_t num_sites() const noexcept {
    return static_cast<std::int32_t>(weights.size());
  }
  [[nodiscard]] std::span<const std::int32_t> edges_of(Site s) const noexcept {
    return std::span(edge_lists)
        .subspan(at(offsets[at(s)]), at(offsets[at(s) + 1] - offsets[at(s)]));
  }
  /// Weight of the roughness against the sum of weighted squared misfits, for a filter
  /// that keeps half of a wave of this (scaled) length on evenly spread nodes.
  [[nodiscard]] double parameter(double wavelength) const noexcept;
  /// (parameter * roughness + weights) x.
  [[nodiscard]] Eigen::VectorXd apply(double parameter, const Eigen::VectorXd& x) const;
};

inline constexpr double most_bend = 4;

/// Second derivatives of an edge's part: of the unknowns at its first end, then at the
/// second.
[[nodiscard]] Eigen::Matrix<double, 6, 6> edge_matrix(const SmoothEdge& edge) noexcept;

/// For at least two sites; `weights` positive.
template <BlendSpace Space>
[[nodiscard]] SmoothSystem smooth_system(
    const typename Space::Triangulation& triangulation, std::span<const double> weights);

}  // namespace delone::interp
