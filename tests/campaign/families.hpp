#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "support/plane_sets.hpp"
#include "support/sphere_sets.hpp"

/// The 29 families of inputs that broke other codes, as generators: P1 to P18 of the
/// plane, S1 to S11 of the sphere. A set is a function of family, seed and size.
namespace delone::campaign {

/// What is checked of a set besides its triangulation.
enum class Extra : std::uint8_t {
  none,
  queries,   ///< every row, points of edges, points beside them are located
  refusals,  ///< with a row that is not finite the library throws, naming that row
  threads,   ///< two to four threads give the same triangulation
};

/// One way of making sets of a family.
struct PlaneVariant {
  const char* name;
  support::PlanePoints (*make)(std::size_t n, std::uint64_t seed);
};
struct SphereVariant {
  const char* name;
  support::SpherePoints (*make)(std::size_t n, std::uint64_t seed);
};

struct Family {
  const char* id;
  const char* title;
  Extra extra = Extra::none;
  std::vector<PlaneVariant> plane = {};
  std::vector<SphereVariant> sphere = {};
};

[[nodiscard]] const std::vector<Family>& plane_families();   ///< P1 to P18
[[nodiscard]] const std::vector<Family>& sphere_families();  ///< S1 to S11
[[nodiscard]] std::vector<Family> all_families();

/// Sizes from 3 to `largest`, n as often as 1 / n^2: mostly small, where every
/// coincidence turns up soon, and now and then large.
[[nodiscard]] std::size_t size_of(std::uint64_t seed, std::size_t largest);

struct PlaneSet {
  const char* variant;
  support::PlanePoints points;
};
struct SphereSet {
  const char* variant;
  support::SpherePoints points;
};

/// A set of a family of the plane: one of its variants, then, as the seed says, thinned,
/// reflected, scaled by a power of two (where that is exact), with rows repeated, in
/// random order. About n rows; some variants round n.
[[nodiscard]] PlaneSet make_plane_set(const Family& family, std::uint64_t seed,
                                      std::size_t n);
/// The same on the sphere: thinned, axes permuted and reflected, repeated, shuffled.
[[nodiscard]] SphereSet make_sphere_set(const Family& family, std::uint64_t seed,
                                        std::size_t n);

}  // namespace delone::campaign
