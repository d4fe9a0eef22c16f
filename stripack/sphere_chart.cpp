#include "stripack/sphere_chart.hpp"

#include "stripack/predicates.hpp"

namespace delone::stripack {

Octant octant_on_cut(const Direction& d) noexcept {
  const bool first =
      d.x() > -d.y() || (d.x() == -d.y() && (d.x() > 0 || (d.x() == 0 && d.z() > 0)));
  const bool is_x_lune = first ? d.x() >= d.y() && d.x() > 0 : d.x() <= d.y();
  return {first ? 0u : 1u, is_x_lune ? 0u : 1u, d.z() >= 0 ? 1u : 0u};
}

namespace {

bool is_pole(const Direction& d) { return d.x() == 0 && d.y() == 0; }

Direction axis(double x, double y, double z) { return Direction::from(x, y, z); }

}  // namespace

// a_x b_y - a_y b_x is det(a, b, z).
bool is_less_u_exactly(const Direction& a, const Direction& b) noexcept {
  if (is_pole(a)) return a.z() < 0 && !is_pole(b);
  if (is_pole(b)) return b.z() > 0;
  return orientation(a, b, axis(0, 0, 1)) > 0;
}

// a_z b_x - a_x b_z is det(a, b, y); a_z b_y - a_y b_z is -det(a, b, x).
bool is_less_v_exactly(const Direction& a, const Direction& b) noexcept {
  const Direction& seen = is_pole(a) ? b : a;
  if (is_pole(seen)) return false;
  const int turn = octant_of(seen).lune == 0 ? orientation(a, b, axis(0, 1, 0))
                                             : -orientation(a, b, axis(1, 0, 0));
  return octant_of(seen).half == 0 ? turn < 0 : turn > 0;
}

}  // namespace delone::stripack
