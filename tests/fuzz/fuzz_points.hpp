#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "stripack/direction.hpp"
#include "tripack/point.hpp"

/// Bytes to points. Text that begins with # is a case of tests/corpus. Otherwise the
/// first byte chooses how the rest is read: as doubles; or as small integers, which
/// collide, line up and lie on circles far more often; in the latter case a further byte
/// scales them.
namespace delone::fuzz {

inline constexpr std::size_t max_points = 48;

[[nodiscard]] std::vector<tripack::Point2> plane_points(
    std::span<const std::uint8_t> bytes);
[[nodiscard]] std::vector<stripack::Direction> sphere_points(
    std::span<const std::uint8_t> bytes);

/// Says what is wrong and stops, which libFuzzer records.
[[noreturn]] void fail(const char* what);

}  // namespace delone::fuzz
