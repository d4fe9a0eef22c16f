#pragma once

#include "interp/grid_lanes.hpp"
#include "interp/lanes_of.hpp"

namespace delone::interp {

/// What GridLanes does.
template <class InstructionSet>
class LaneScan {
  using Lanes = LanesOf<InstructionSet>;
  using Numbers = typename Lanes::Numbers;
  using Bits = typename Lanes::Bits;

 public:
  template <class Sides, class Facet, class Axes>
  [[gnu::always_inline]] static NodeMask fill(const Sides& sides, const Facet& facet,
                                              const Axes& axes, const NodeBlock& block,
                                              const GridValues& out) {
    const Facet f = facet;
    const GridValues to = out;
    return visit(sides, axes, block,
                 [&](std::int64_t j, std::int64_t i, const Bits& bits, const auto& p) {
                   Lanes::store(to.node(i, j), bits, value(f, p));
                 });
  }

  template <class Sides, class Axes>
  [[gnu::always_inline]] static Cover cover(const Sides& sides, const Axes& axes,
                                            const NodeBlock& block) {
    Cover result;
    const IndexRange rows = block.rows;
    const std::int64_t first_column = block.columns.begin;
    for (std::int64_t r = 0; r < rows.end - rows.begin; ++r) result.inside.rows[r] = 0;
    result.doubtful = visit(
        sides, axes, block,
        [&](std::int64_t j, std::int64_t i, const Bits& bits, const auto&) {
          result.inside.rows[j - rows.begin] |= Lanes::word(bits) << (i - first_column);
        });
    return result;
  }

 private:
  // Columns side by side, and their nodes in a row.
  struct PlaneColumns {
    Numbers x;
  };
  struct PlaneNodes {
    Numbers x;
    double y;
  };
  struct GlobeColumns {
    Numbers cos_lon, sin_lon;
  };
  struct GlobeNodes {
    Numbers x, y;
    double z;
  };
  [[gnu::always_inline]] static PlaneColumns columns(const PlaneAxes& axes,
                                                     std::int64_t i) {
    return {Lanes::load(axes.x + i)};
  }
  [[gnu::always_inline]] static GlobeColumns columns(const GlobeAxes& axes,
                                                     std::int64_t i) {
    return {Lanes::load(axes.cos_lon + i), Lanes::load(axes.sin_lon + i)};
  }
  [[gnu::always_inline]] static PlaneNodes nodes(const PlaneColumns& c,
                                                 const PlaneAxes& axes, std::int64_t j) {
    return {c.x, axes.y[j]};
  }
  [[gnu::always_inline]] static GlobeNodes nodes(const GlobeColumns& c,
                                                 const GlobeAxes& axes, std::int64_t j) {
    const double across = axes.cos_lat[j];
    return {across * c.cos_lon, across * c.sin_lon, axes.sin_lat[j]};
  }

  [[gnu::always_inline]] static Numbers side(const PlaneSides& s, std::size_t k,
                                             const PlaneNodes& p) {
    return s.dx[k] * (p.y - s.y[k]) - s.dy[k] * (p.x - s.x[k]);
  }
  [[gnu::always_inline]] static Numbers side(const SphereSides& s, std::size_t k,
                                             const GlobeNodes& p) {
    const Vector3& n = s.normals[k];
    return (n.z * p.z + n.x * p.x) + n.y * p.y;
  }

  [[gnu::always_inline]] static Numbers value(const PlainPlaneFacet& f,
                                              const PlaneNodes& p) {
    const double start = f.value + f.y_slope * (p.y - f.origin.y);
    return kept_between(f.low, f.high, start + f.x_slope * (p.x - f.origin.x));
  }
  [[gnu::always_inline]] static Numbers value(const PlainSphereFacet& f,
                                              const GlobeNodes& p) {
    const Numbers rise =
        (f.slope.z * (p.z - f.origin.z) + f.slope.x * (p.x - f.origin.x)) +
        f.slope.y * (p.y - f.origin.y);
    const Numbers height = (f.normal.z * p.z + f.normal.x * p.x) + f.normal.y * p.y;
    return kept_between(f.low, f.high, f.value + rise / height);
  }
  [[gnu::always_inline]] static Numbers kept_between(double low, double high,
                                                     const Numbers& v) {
    return Lanes::at_least(Lanes::at_most(v, Lanes::all(high)), Lanes::all(low));
  }

  // Calls inside(row, column, bits, nodes) for groups of columns, and returns the
  // doubtful nodes. Works on copies that what `inside` writes cannot change: kept in
  // registers.
  template <class Sides, class Axes, class Inside>
  [[gnu::always_inline]] static NodeMask visit(const Sides& given_sides,
                                               const Axes& given_axes,
                                               const NodeBlock& given_block,
                                               Inside inside) {
    const Sides sides = given_sides;
    const Axes axes = given_axes;
    const NodeBlock block = given_block;
    const Numbers error = Lanes::all(sides.error);
    NodeMask doubtful;
    for (std::int64_t i = block.columns.begin; i < block.columns.end; i += Lanes::size) {
      const auto c = columns(axes, i);
      const std::int64_t shift = i - block.columns.begin;
      for (std::int64_t j = block.rows.begin; j < block.rows.end; ++j) {
        const auto p = nodes(c, axes, j);
        const Numbers least = Lanes::at_most(
            Lanes::at_most(side(sides, 0, p), side(sides, 1, p)), side(sides, 2, p));
        const Bits are_inside = Lanes::are_above(least, error);
        const std::uint64_t in_doubt =
            Lanes::word(Lanes::are_from(least, -error)) & ~Lanes::word(are_inside);
        std::uint64_t& row = doubtful.rows[j - block.rows.begin];
        row = (shift == 0 ? 0 : row) | in_doubt << shift;
        inside(j, i, are_inside, p);
      }
    }
    return doubtful;
  }
};

/// What grid_lanes.hpp declares, compiled for an instruction set
/// (delaunay/instruction_set.hpp).
template <class InstructionSet>
struct GridLanes {
  [[nodiscard]] static NodeMask fill(const PlaneSides& sides,
                                     const PlainPlaneFacet& facet, const PlaneAxes& axes,
                                     const NodeBlock& block, const GridValues& out);
  [[nodiscard]] static NodeMask fill(const SphereSides& sides,
                                     const PlainSphereFacet& facet, const GlobeAxes& axes,
                                     const NodeBlock& block, const GridValues& out);
  [[nodiscard]] static Cover cover(const PlaneSides& sides, const PlaneAxes& axes,
                                   const NodeBlock& block);
  [[nodiscard]] static Cover cover(const SphereSides& sides, const GlobeAxes& axes,
                                   const NodeBlock& block);
};

template <class InstructionSet>
NodeMask GridLanes<InstructionSet>::fill(const PlaneSides& sides,
                                         const PlainPlaneFacet& facet,
                                         const PlaneAxes& axes, const NodeBlock& block,
                                         const GridValues& out) {
  return LaneScan<InstructionSet>::fill(sides, facet, axes, block, out);
}

template <class InstructionSet>
NodeMask GridLanes<InstructionSet>::fill(const SphereSides& sides,
                                         const PlainSphereFacet& facet,
                                         const GlobeAxes& axes, const NodeBlock& block,
                                         const GridValues& out) {
  return LaneScan<InstructionSet>::fill(sides, facet, axes, block, out);
}

template <class InstructionSet>
Cover GridLanes<InstructionSet>::cover(const PlaneSides& sides, const PlaneAxes& axes,
                                       const NodeBlock& block) {
  return LaneScan<InstructionSet>::cover(sides, axes, block);
}

template <class InstructionSet>
Cover GridLanes<InstructionSet>::cover(const SphereSides& sides, const GlobeAxes& axes,
                                       const NodeBlock& block) {
  return LaneScan<InstructionSet>::cover(sides, axes, block);
}

#if defined(DELONE_AVX2)
extern template struct GridLanes<delaunay::Avx2>;
extern template struct GridLanes<Avx512>;
#endif

}  // namespace delone::interp
