#include "io/map_raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace delone::io {
namespace {

struct Tap {
  std::int64_t node;
  double weight;
};

/// What a row or column of pixels takes from one axis of the grid.
struct Sample {
  std::int64_t nearest = 0;
  std::vector<Tap> taps;
};

/// A node outside the axis is its other end if the axis closes, and nothing (-1) if not.
std::int64_t node_at(std::int64_t place, const interp::Axis& axis, bool is_cyclic) {
  if (place >= 0 && place < axis.size) return place;
  if (!is_cyclic) return -1;
  const std::int64_t rest = place % axis.size;
  return rest < 0 ? rest + axis.size : rest;
}

/// `place` in spacings from the first node; `radius` of the tent in spacings.
Sample sample_at(double place, double radius, const interp::Axis& axis, bool is_cyclic) {
  Sample sample;
  const auto nearest = static_cast<std::int64_t>(std::floor(place + 0.5));
  sample.nearest = std::clamp<std::int64_t>(
      is_cyclic ? node_at(nearest, axis, true) : nearest, 0, axis.size - 1);
  const auto first = static_cast<std::int64_t>(std::ceil(place - radius));
  const auto last = static_cast<std::int64_t>(std::floor(place + radius));
  for (std::int64_t i = first; i <= last; ++i) {
    const double weight = 1 - std::abs(place - static_cast<double>(i)) / radius;
    const std::int64_t node = node_at(i, axis, is_cyclic);
    if (weight > 0 && node >= 0) sample.taps.push_back({node, weight});
  }
  return sample;
}

std::vector<Sample> sample_axis(const interp::Axis& axis, double low, double high,
                                int num_pixels, bool is_cyclic) {
  const double pixel = (high - low) / num_pixels;
  const double radius = std::max(1.0, pixel / axis.spacing);
  std::vector<Sample> samples;
  samples.reserve(static_cast<std::size_t>(num_pixels));
  for (int i = 0; i < num_pixels; ++i) {
    const double coordinate = low + (i + 0.5) * pixel;
    samples.push_back(sample_at((coordinate - axis.coordinate(0)) / axis.spacing, radius,
                                axis, is_cyclic));
  }
  return samples;
}

class Sampler {
 public:
  explicit Sampler(const interp::Field& field) : field_(field) {}

  /// NaN where the nearest node is missing.
  [[nodiscard]] double value(const Sample& x, const Sample& y) const {
    const double nearest = node(x.nearest, y.nearest);
    if (!std::isfinite(nearest)) return std::nan("");
    double weight = 0;
    for (const Tap& row : y.taps)
      for (const Tap& column : x.taps)
        if (std::isfinite(node(column.node, row.node)))
          weight += row.weight * column.weight;
    return weight > 0 ? mean(x, y, weight) : nearest;
  }

 private:
  [[nodiscard]] double node(std::int64_t i, std::int64_t j) const {
    return field_.values[static_cast<std::size_t>(j * field_.grid.x.size + i)];
  }

  /// The weights are made to add up to one before they meet the values, which may be
  /// close to the largest double.
  [[nodiscard]] double mean(const Sample& x, const Sample& y, double weight) const {
    double sum = 0;
    for (const Tap& row : y.taps)
      for (const Tap& column : x.taps) {
        const double value = node(column.node, row.node);
        if (std::isfinite(value)) sum += row.weight * column.weight / weight * value;
      }
    return sum;
  }

  const interp::Field& field_;
};

}  // namespace

Raster rasterize(const interp::Field& field, const MapFrame& frame,
                 const ColorScale& scale, int width, int height) {
  const auto columns =
      sample_axis(field.grid.x, frame.west, frame.east, width, frame.is_closed);
  const auto rows = sample_axis(field.grid.y, frame.south, frame.north, height, false);
  const Sampler sampler(field);
  Raster raster{width, height, {}};
  raster.pixels.reserve(columns.size() * rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const Sample& column : columns) {
      const double value = sampler.value(column, *row);
      raster.pixels.push_back(std::isnan(value) ? blank_color : scale.color(value));
    }
  return raster;
}

Raster with_dots(Raster raster, const RasterDots& dots) {
  const int half = dots.size / 2;
  for (std::size_t i = 0; i < dots.right.size(); ++i) {
    const double right = dots.right[i], up = dots.up[i];
    // False for NaN too.
    if (!(right >= 0 && right < 1 && up > 0 && up <= 1)) continue;
    const int left = static_cast<int>(right * raster.width) - half;
    const int top = static_cast<int>((1 - up) * raster.height) - half;
    for (int row = std::max(top, 0); row < std::min(top + dots.size, raster.height);
         ++row)
      for (int column = std::max(left, 0);
           column < std::min(left + dots.size, raster.width); ++column)
        raster.pixels[raster.index(column, row)] = dots.color;
  }
  return raster;
}

}  // namespace delone::io
