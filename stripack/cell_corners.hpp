#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "stripack/fan.hpp"
#include "stripack/local_frame.hpp"
#include "stripack/voronoi_cell.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

/// The corners of Voronoi cells in central projection from their sites, a register full
/// at a time. Internal: use stripack/voronoi.hpp.
namespace delone::stripack {

/// What a register holds; results are bitwise the same for every one. Comparing and
/// choosing are slow where the type is wider than that.
template <class InstructionSet>
struct Lanes {
  using Number = Double2;
  using Mask = std::int64_t __attribute__((vector_size(16)));
  static constexpr int size = 2;
  static constexpr Mask index{0, 1};
  template <class F>
  [[gnu::always_inline]] static Number fill(F lane) noexcept {
    return Number{lane(0), lane(1)};
  }
  [[gnu::always_inline]] static Number after(const Number& a, const Number& b) noexcept {
    return __builtin_shufflevector(a, b, 1, 2);
  }
  [[gnu::always_inline]] static unsigned bits(const Mask& mask) noexcept {
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
#else
    return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2));
#endif
  }
  [[gnu::always_inline]] static Number root(const Number& a) noexcept {
#if defined(__SSE2__)
    return _mm_sqrt_pd(a);
#else
    return Number{std::sqrt(a[0]), std::sqrt(a[1])};
#endif
  }
};

#if defined(__AVX2__)
template <>
struct Lanes<delaunay::Avx2> {
  using Number = delaunay::Double4;
  using Mask = delaunay::Mask4;
  static constexpr int size = 4;
  static constexpr Mask index{0, 1, 2, 3};
  template <class F>
  [[gnu::always_inline]] static Number fill(F lane) noexcept {
    return Number{lane(0), lane(1), lane(2), lane(3)};
  }
  [[gnu::always_inline]] static Number after(const Number& a, const Number& b) noexcept {
    return __builtin_shufflevector(a, b, 1, 2, 3, 4);
  }
  [[gnu::always_inline]] static unsigned bits(const Mask& mask) noexcept {
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
  }
  [[gnu::always_inline]] static Number root(const Number& a) noexcept {
    return _mm256_sqrt_pd(a);
  }
};
#endif

/// The corners of one cell after another. Memory is kept from one to the next.
///
/// Lanes behind the last corner repeat the first one: a triangle between equal corners
/// has no area, exactly. The factors of the area are multiplied in four chains, corner k
/// in chain k mod 4, so that the result is bitwise the same for every register.
template <class InstructionSet>
class CellCorners {
 public:
  /// Finds the circumcentre of the site and each two sites in a row of `around`, which
  /// are three or more and in a cycle. False if one is farther than 63 degrees away.
  [[nodiscard]] bool place(const LocalFrame& frame, std::span<const Direction> points,
                           std::span<const Site> around) {
    frame_ = &frame;
    points_ = points;
    around_ = around;
    blocks_.resize((around.size() + width - 1) / width);
    for (std::size_t j = 0; j < blocks_.size(); ++j) see(j);
    Mask is_far{};
    for (std::size_t j = 0; j < blocks_.size(); ++j) is_far |= find_centers(j);
    repeat_first_corner();
    return Lane::bits(is_far) == 0;
  }

  [[nodiscard, gnu::always_inline]] HalfAreas half_area() const noexcept {
    constexpr std::size_t num_parts = 4 / width;
    Number re[num_parts], im[num_parts];
    for (std::size_t i = 0; i < num_parts; ++i) re[i] = Number{} + 1, im[i] = Number{};
    for (std::size_t j = 0; j < blocks_.size(); ++j) {
      const Number t = tan_half_excesses(j);
      Number &r = re[j % num_parts], &i = im[j % num_parts];
      const Number real = r - i * t;
      i = r * t + i;
      r = real;
    }
    HalfAreas halves{re[0][0], im[0][0]};
    for (std::size_t k = 1; k < 4; ++k)
      halves.turn(re[k / width][k % width], im[k / width][k % width]);
    return halves;
  }

  [[nodiscard]] std::size_t size() const noexcept { return around_.size(); }
  [[nodiscard]] Corner operator[](std::size_t k) const noexcept {
    const Block& b = blocks_[k / width];
    return {b.x[k % width], b.y[k % width], b.length[k % width]};
  }

 private:
  using Lane = Lanes<InstructionSet>;
  using Number = typename Lane::Number;
  using Mask = typename Lane::Mask;
  using Centers = Circumcenters<Number>;
  static constexpr std::size_t width = Lane::size;

  struct Block {
    BasicSpaceVector<Number> site;
    BasicSpoke<Number> spoke;
    Number x, y, length;
  };

  [[nodiscard, gnu::always_inline]] const Direction& point(std::size_t k) const noexcept {
    return points_[static_cast<std::size_t>(around_[k < around_.size() ? k : 0])];
  }
  [[nodiscard, gnu::always_inline]] const Block& following(std::size_t j) const noexcept {
    return blocks_[j + 1 == blocks_.size() ? 0 : j + 1];
  }
  /// Lanes of a block that belong to the cell.
  [[nodiscard, gnu::always_inline]] Mask used(std::size_t j) const noexcept {
    return Lane::index < Mask{} + static_cast<std::int64_t>(around_.size() - width * j);
  }

  [[gnu::always_inline]] void see(std::size_t j) noexcept {
    Block& b = blocks_[j];
    const auto p = [&](std::size_t i) -> const Direction& {
      return point(width * j + i);
    };
    b.site = {Lane::fill([&](std::size_t i) { return p(i).x(); }),
              Lane::fill([&](std::size_t i) { return p(i).y(); }),
              Lane::fill([&](std::size_t i) { return p(i).z(); })};
    b.spoke = frame_->open_spoke(b.site);
    const unsigned close = Lane::bits(LocalFrame::is_close(b.spoke));
    if (close != 0) see_close_sites(j, close);
  }
  [[gnu::noinline]] void see_close_sites(std::size_t j, unsigned close) noexcept {
    for (std::size_t i = 0; i < width; ++i) {
      if ((close >> i & 1) == 0) continue;
      const Spoke s = frame_->spoke(point(width * j + i));
      BasicSpoke<Number>& lanes = blocks_[j].spoke;
      lanes.x[i] = s.x, lanes.y[i] = s.y;
      lanes.square[i] = s.square, lanes.rise[i] = s.rise;
    }
  }

  /// Gives back which of them are far away.
  [[gnu::always_inline]] Mask find_centers(std::size_t j) noexcept {
    Block& b = blocks_[j];
    const BasicSpoke<Number>&s = b.spoke, &t = following(j).spoke;
    const BasicSpoke<Number> next{Lane::after(s.x, t.x), Lane::after(s.y, t.y),
                                  Lane::after(s.square, t.square),
                                  Lane::after(s.rise, t.rise)};
    BasicLocalVector<Number> center = Centers::plain(s, next);
    const Mask is_used = used(j),
               is_needle = is_used & ~Centers::is_plain(center, s, next);
    if (Lane::bits(is_needle) != 0) center = find_needles(j, center, next, is_needle);
    const Number square = center.x * center.x + center.y * center.y;
    const Mask is_near = (center.up > 0) & (square < 4 * (center.up * center.up));
    const Number scale = 1 / center.up;
    b.x = center.x * scale;
    b.y = center.y * scale;
    b.length = Lane::root(1 + b.x * b.x + b.y * b.y);
    return is_used & ~is_near;
  }

  [[nodiscard, gnu::always_inline]] BasicLocalVector<Number> find_needles(
      std::size_t j, const BasicLocalVector<Number>& plain,
      const BasicSpoke<Number>& next, const Mask& is_asked) const noexcept {
    const Block &b = blocks_[j], &c = following(j);
    const BasicSpaceVector<Number> next_site{Lane::after(b.site.x, c.site.x),
                                             Lane::after(b.site.y, c.site.y),
                                             Lane::after(b.site.z, c.site.z)};
    const BasicSide<Number> e = frame_->side(b.site, next_site, b.spoke);
    const auto needle = Centers::of_needle(b.spoke, next, e);
    const Mask is_needle = Centers::is_needle(needle, b.spoke, next, e);
    BasicLocalVector<Number> center{is_asked ? needle.up : plain.up,
                                    is_asked ? needle.x : plain.x,
                                    is_asked ? needle.y : plain.y};
    const unsigned rest = Lane::bits(is_asked & ~is_needle);
    for (std::size_t i = 0; rest >> i != 0; ++i) {
      if ((rest >> i & 1) == 0) continue;
      const LocalVector wide =
          frame_->circumcenter_wide(point(width * j + i), point(width * j + i + 1));
      center.up[i] = wide.up, center.x[i] = wide.x, center.y[i] = wide.y;
    }
    return center;
  }

  [[gnu::always_inline]] void repeat_first_corner() noexcept {
    Block& b = blocks_.back();
    const Mask is_used = used(blocks_.size() - 1);
    const Corner first = (*this)[0];
    b.x = is_used ? b.x : Number{} + first.x;
    b.y = is_used ? b.y : Number{} + first.y;
    b.length = is_used ? b.length : Number{} + first.length;
  }

  /// Of the triangles of the site, a corner and the next.
  [[nodiscard, gnu::always_inline]] Number tan_half_excesses(
      std::size_t j) const noexcept {
    const Block &b = blocks_[j], &c = following(j);
    const Number x = Lane::after(b.x, c.x), y = Lane::after(b.y, c.y),
                 length = Lane::after(b.length, c.length);
    return (b.x * y - b.y * x) /
           (b.length * length + b.length + length + 1 + b.x * x + b.y * y);
  }

  const LocalFrame* frame_ = nullptr;
  std::span<const Direction> points_;
  std::span<const Site> around_;
  std::vector<Block> blocks_;
};

/// Halves of the areas of the cells from `first` on; {0, 0} for those that have fewer
/// than three corners or one farther away than 63 degrees.
template <class InstructionSet>
struct HalfAreaWork {
  static void work(std::span<const Direction> points, const CellNeighbors& neighbors,
                   Site first, std::span<HalfAreas> result) {
    CellCorners<InstructionSet> corners;
    for (HalfAreas& half : result) {
      const std::span<const Site> around = neighbors(first);
      const LocalFrame frame(points[static_cast<std::size_t>(first)]);
      const bool is_near = around.size() > 2 && corners.place(frame, points, around);
      half = is_near ? corners.half_area() : HalfAreas{0, 0};
      ++first;
    }
  }
};
using HalfAreaFunction = void (*)(std::span<const Direction>, const CellNeighbors&, Site,
                                  std::span<HalfAreas>);
[[nodiscard]] HalfAreaFunction half_areas_avx2() noexcept;

}  // namespace delone::stripack
