#pragma once

#include <optional>

#include "stripack/direction.hpp"
#include "stripack/predicate_filters.hpp"

/// The further rungs of the predicates for directions. Internal: use
/// stripack/predicates.hpp.
namespace delone::stripack {

/// In 192 bits: exact where a's coordinates fit into 61 bits, else certain or nothing.
[[nodiscard]] std::optional<int> orientation_integer(const Direction& a,
                                                     const Direction& b,
                                                     const Direction& c) noexcept;
/// Exact for all directions.
[[nodiscard]] int orientation_exact(const Direction& a, const Direction& b,
                                    const Direction& c) noexcept;

/// In 320 bits, +1 or -1 or nothing: undecided are exact ties, and points so close to one
/// circle that the lengths matter.
[[nodiscard]] std::optional<int> in_circle_integer(const Direction& a, const Direction& b,
                                                   const Direction& c,
                                                   const Direction& p) noexcept;
/// Exact, or nothing: undecided are directions that are not multiples of 2^-60, and those
/// whose lengths differ and matter. Decides exact ties, which symmetry makes of
/// directions of equal length.
[[nodiscard]] std::optional<int> in_circle_of_fixed_points(const Direction& a,
                                                           const Direction& b,
                                                           const Direction& c,
                                                           const Direction& p) noexcept;
/// Exact for all directions.
[[nodiscard]] int in_circle_exact(const Direction& a, const Direction& b,
                                  const Direction& c, const Direction& p) noexcept;

/// Exact sign of ux vy - uy vx, for coordinates of directions.
[[nodiscard]] int cross_sign(double ux, double uy, double vx, double vy) noexcept;

/// The sign that the perturbation gives to four cocircular directions.
[[nodiscard]] int break_tie(const Direction& a, const Direction& b, const Direction& c,
                            const Direction& p) noexcept;

}  // namespace delone::stripack
