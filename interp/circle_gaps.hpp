#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace delone::interp {

/// What up to three arcs leave of a circle, in order. A turn of the circle is `turn`
/// long; positions are modulo that.
class CircleGaps {
 public:
  explicit CircleGaps(double turn) noexcept : turn_(turn) {}

  /// The closed arc of the given half width, 0 .. turn / 2, around `center`, which is
  /// within a few turns of 0.
  void exclude(double center, double half_width) noexcept {
    double begin = center - half_width;
    while (begin < 0) begin += turn_;
    while (begin >= turn_) begin -= turn_;
    std::size_t k = size_++;  // kept in order of their beginnings
    for (; k > 0 && arcs_[k - 1].begin > begin; --k) arcs_[k] = arcs_[k - 1];
    arcs_[k] = {begin, begin + 2 * half_width};
  }

  [[nodiscard]] bool is_whole_circle() const noexcept { return size_ == 0; }

  /// Calls f(begin, end) for the gaps, also for those that are negative by no more than
  /// `slack`. There must be an arc. Positions grow from gap to gap, and may be beyond one
  /// turn.
  template <class F>
  void for_each_gap(double slack, F f) {
    double covered = arcs_[0].end;
    for (std::size_t k = 1; k < size_; ++k)
      covered = std::max(covered, arcs_[k].end - turn_);
    for (std::size_t k = 1; k <= size_; ++k) {
      const double next = k < size_ ? arcs_[k].begin : arcs_[0].begin + turn_;
      if (next - covered >= -slack) f(covered, next);
      if (k < size_) covered = std::max(covered, arcs_[k].end);
    }
  }

 private:
  struct Arc {
    double begin, end;
  };
  double turn_;
  std::array<Arc, 3> arcs_{};
  std::size_t size_ = 0;
};

}  // namespace delone::interp
