#include "io/coastline.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "io/coastline_table.hpp"

namespace delone::io {
namespace {

bool meets(const CoastPoint& p, const CoastPoint& q, double turn_deg,
           const LonLatBox& box) {
  const auto [west, east] = std::minmax(p.lon_deg, q.lon_deg);
  const auto [south, north] = std::minmax(p.lat_deg, q.lat_deg);
  return west + turn_deg <= box.east_deg && east + turn_deg >= box.west_deg &&
         south <= box.north_deg && north >= box.south_deg;
}

/// The runs of segments that meet the box, collected line by line.
class Collector {
 public:
  explicit Collector(const LonLatBox& box) : box_(box) {}

  /// `line` at every whole turn that may bring it into the box.
  void add(std::span<const CoastPoint> line) {
    const auto [west, east] = std::minmax_element(
        line.begin(), line.end(),
        [](const auto& p, const auto& q) { return p.lon_deg < q.lon_deg; });
    const double first = std::ceil((box_.west_deg - east->lon_deg) / 360);
    const double last = std::floor((box_.east_deg - west->lon_deg) / 360);
    for (double turn = first; turn <= last; ++turn) add_turned(line, 360 * turn);
  }

  [[nodiscard]] std::vector<CoastLine> take() { return std::move(runs_); }

 private:
  void add_turned(std::span<const CoastPoint> line, double turn_deg) {
    const auto turned = [turn_deg](const CoastPoint& p) {
      return stripack::LonLat{p.lon_deg + turn_deg, p.lat_deg};
    };
    bool is_running = false;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const bool is_inside = meets(line[i - 1], line[i], turn_deg, box_);
      if (is_inside && !is_running) runs_.push_back({turned(line[i - 1])});
      if (is_inside) runs_.back().push_back(turned(line[i]));
      is_running = is_inside;
    }
  }

  LonLatBox box_;
  std::vector<CoastLine> runs_;
};

}  // namespace

std::vector<CoastLine> coast_in(const LonLatBox& box) {
  Collector collector(box);
  auto rest = coast_points();
  while (!rest.empty()) {
    const auto end = std::find_if(rest.begin(), rest.end(), [&rest](const CoastPoint& p) {
      return p.line != rest.front().line;
    });
    const auto length = static_cast<std::size_t>(end - rest.begin());
    collector.add(rest.first(length));
    rest = rest.subspan(length);
  }
  return collector.take();
}

}  // namespace delone::io
