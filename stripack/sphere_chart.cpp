#include "stripack/sphere_chart.hpp"

#include "stripack/predicate_rungs.hpp"

namespace delone::stripack {

Octant octant_on_cut(const Direction& d) noexcept {
  const bool first =
      d.x() > -d.y() || (d.x() == -d.y() && (d.x() > 0 || (d.x() == 0 && d.z() > 0)));
  const bool is_x_lune = first ? d.x() >= d.y() && d.x() > 0 : d.x() <= d.y();
  return {first ? 0u : 1u, is_x_lune ? 0u : 1u, d.z() >= 0 ? 1u : 0u};
}

namespace {

bool is_pole(const Direction& d) { return d.x() == 0 && d.y() == 0; }

}  // namespace

bool is_less_u_exactly(const Direction& a, const Direction& b) noexcept {
  if (is_pole(a)) return a.z() < 0 && !is_pole(b);
  if (is_pole(b)) return b.z() > 0;
  return cross_sign(a.x(), a.y(), b.x(), b.y()) > 0;
}

bool is_less_v_exactly(const Direction& a, const Direction& b) noexcept {
  const Direction& seen = is_pole(a) ? b : a;
  if (is_pole(seen)) return false;
  const Octant octant = octant_of(seen);
  const int turn = octant.lune == 0 ? cross_sign(a.z(), a.x(), b.z(), b.x())
                                    : cross_sign(a.z(), a.y(), b.z(), b.y());
  return octant.half == 0 ? turn < 0 : turn > 0;
}

}  // namespace delone::stripack
