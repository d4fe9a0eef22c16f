#pragma once

#include "interp/cursor.hpp"
#include "interp/reach.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

/// What nearest surfaces and their operators refuse. Throws Error.
inline void check_nearest(const SurfaceOptions& options) {
  check(options);
  if (options.outside == Outside::linear) {
    throw Error("nearest values have no linear continuation; take nearest or missing");
  }
}

/// The site whose value a nearest surface has at p; none: missing.
template <class Triangulation, class Point>
[[nodiscard]] Site nearest_answer(const Triangulation& t, const SurfaceOptions& options,
                                  const Point& p, Cursor& cursor) {
  if (t.num_sites() == 0 || !is_finite(p)) return none;
  if (options.outside == Outside::missing &&
      find_spot(t, p, cursor.arc).kind == Spot::Kind::outside)
    return none;
  cursor.site = nearest_site(t, p, cursor.site);
  return reach_of(t, options).covers(p, cursor.site) ? cursor.site : none;
}

}  // namespace delone::interp
