#include "io/picture_projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace delone::io {
namespace {

double dot(const SpacePoint& a, const SpacePoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

SpacePoint normalized(const SpacePoint& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

/// Halfway along the arc; of opposite points some place halfway.
SpacePoint midpoint(const SpacePoint& a, const SpacePoint& b) {
  const SpacePoint sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  if (dot(sum, sum) > 1e-20) return normalized(sum);
  return std::hypot(a[0], a[1]) > 0.5 ? normalized({-a[1], a[0], 0})
                                      : normalized({0, -a[2], a[1]});
}

/// Where the arc between two points of different heights meets the horizon.
SpacePoint at_horizon(const SpacePoint& above, double height, const SpacePoint& below,
                      double depth) {
  SpacePoint sum{};
  for (std::size_t k = 0; k < 3; ++k) sum[k] = below[k] * height + above[k] * depth;
  return dot(sum, sum) > 0 ? normalized(sum) : above;
}

SpacePoint to_direction(double lon_deg, double lat_deg) {
  const auto d = stripack::Direction::from({lon_deg, lat_deg});
  return {d.x(), d.y(), d.z()};
}

/// Can the arc be drawn as a straight piece? By its length, and on a map by its
/// longitudes too, which run fast near a pole.
bool is_short(const SpacePoint& a, const SpacePoint& b, Projection::Kind kind,
              double longest) {
  const double chord = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  if (chord > longest) return false;
  if (kind != Projection::Kind::map || chord < longest / 50) return true;
  const double turn = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  return std::abs(turn) < 2 * longest;
}

/// The part of a segment inside a box, as parameters; an empty one if low > high.
struct Part {
  double low = 0, high = 1;
};

/// Liang and Barsky: the half-plane where p * t <= q.
void cut(Part& part, double p, double q) {
  if (p == 0) {
    if (q < 0) part = {1, 0};
    return;
  }
  const double t = q / p;
  if (p < 0)
    part.low = std::max(part.low, t);
  else
    part.high = std::min(part.high, t);
}

}  // namespace

// A hundredth of the picture, but not so short that an arc around the globe has millions.
Projection::Projection(Kind kind, const MapFrame& frame, const CanvasBox& plot)
    : kind_(kind),
      frame_(frame),
      plot_(plot),
      longest_piece_(std::clamp((frame.east - frame.west) / 100, 0.02, 2.5) *
                     std::numbers::pi / 180) {}

Projection::Projection(stripack::LonLat centre, const CanvasBox& plot)
    : kind_(Kind::orthographic),
      plot_(plot),
      up_(to_direction(centre.lon_deg, centre.lat_deg)),
      east_(to_direction(centre.lon_deg + 90, 0)),
      north_{up_[1] * east_[2] - up_[2] * east_[1], up_[2] * east_[0] - up_[0] * east_[2],
             up_[0] * east_[1] - up_[1] * east_[0]} {}

SpacePoint Projection::direction(const PicturePoint& p) const {
  return to_direction(p[0], std::clamp(p[1], -90.0, 90.0));
}

CanvasPoint Projection::on_frame(double x, double y) const {
  return {plot_.left + (x - frame_.west) / (frame_.east - frame_.west) * plot_.width,
          plot_.top + (frame_.north - y) / (frame_.north - frame_.south) * plot_.height};
}

CanvasPoint Projection::on_disc(const SpacePoint& d) const {
  const double radius = plot_.width / 2;
  return {plot_.left + radius * (1 + dot(d, east_)),
          plot_.top + radius * (1 - dot(d, north_))};
}

/// Above the plane of the horizon.
double Projection::height(const SpacePoint& d) const { return dot(d, up_); }

std::optional<CanvasPoint> Projection::place(const PicturePoint& p) const {
  if (kind_ == Kind::orthographic) {
    const SpacePoint d = direction(p);
    if (height(d) < 0) return std::nullopt;
    return on_disc(d);
  }
  const bool is_map = kind_ == Kind::map;
  const double x = is_map ? p[0] + 360 * std::ceil((frame_.west - p[0]) / 360) : p[0];
  const bool is_inside = x >= frame_.west && x <= frame_.east && p[1] >= frame_.south &&
                         p[1] <= frame_.north;
  if (!is_inside) return std::nullopt;
  return on_frame(x, p[1]);
}

std::vector<CanvasLine> Projection::visible(const PictureLine& line) const {
  if (kind_ == Kind::orthographic) return on_near_side(subdivided(line));
  std::vector<CanvasLine> parts;
  if (kind_ == Kind::plane) {
    add_clipped(line, 0, parts);
    return parts;
  }
  const PictureLine path = unwrapped(subdivided(line));
  const auto [west, east] =
      std::ranges::minmax(path, {}, [](const PicturePoint& p) { return p[0]; });
  const double first = std::ceil((frame_.west - east[0]) / 360);
  const double last = std::floor((frame_.east - west[0]) / 360);
  for (double turn = first; turn <= last; ++turn) add_clipped(path, 360 * turn, parts);
  return parts;
}

/// The arcs in pieces that may be drawn straight.
std::vector<SpacePoint> Projection::subdivided(const PictureLine& line) const {
  std::vector<SpacePoint> points;
  for (const PicturePoint& p : line) {
    const SpacePoint end = direction(p);
    std::vector<SpacePoint> ahead{end};  // a stack: the nearest on top
    while (!points.empty() && !ahead.empty()) {
      if (is_short(points.back(), ahead.back(), kind_, longest_piece_)) {
        points.push_back(ahead.back());
        ahead.pop_back();
      } else {
        ahead.push_back(midpoint(points.back(), ahead.back()));
      }
    }
    if (points.empty()) points.push_back(end);
  }
  return points;
}

/// Longitudes that run on from point to point.
PictureLine Projection::unwrapped(const std::vector<SpacePoint>& arcs) const {
  PictureLine line;
  for (const SpacePoint& d : arcs) {
    const auto p = lonlat(stripack::Direction::from(d[0], d[1], d[2]));
    if (line.empty()) {
      line.push_back({p.lon_deg, p.lat_deg});
      continue;
    }
    const bool is_pole = std::hypot(d[0], d[1]) < 1e-9;
    const double last = line.back()[0];
    const double next = is_pole ? last : last + std::remainder(p.lon_deg - last, 360);
    line.push_back({next, p.lat_deg});
  }
  return line;
}

void Projection::add_clipped(const PictureLine& line, double shift,
                             std::vector<CanvasLine>& parts) const {
  const double margin_x = 0.02 * (frame_.east - frame_.west);
  const double margin_y = 0.02 * (frame_.north - frame_.south);
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double x = line[i][0] + shift, y = line[i][1];
    const double dx = line[i + 1][0] - line[i][0], dy = line[i + 1][1] - y;
    Part part;
    cut(part, -dx, x - (frame_.west - margin_x));
    cut(part, dx, frame_.east + margin_x - x);
    cut(part, -dy, y - (frame_.south - margin_y));
    cut(part, dy, frame_.north + margin_y - y);
    // False for NaN too.
    if (!(part.low <= part.high)) {
      goes_on = false;
      continue;
    }
    if (!goes_on || part.low > 0)
      parts.push_back({on_frame(x + part.low * dx, y + part.low * dy)});
    parts.back().push_back(on_frame(x + part.high * dx, y + part.high * dy));
    goes_on = part.high == 1;
  }
}

std::vector<CanvasLine> Projection::on_near_side(
    const std::vector<SpacePoint>& arcs) const {
  std::vector<CanvasLine> parts;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const double here = height(arcs[i]);
    const double before = i == 0 ? here : height(arcs[i - 1]);
    if (here >= 0) {
      if (i == 0 || before < 0) parts.emplace_back();
      if (before < 0)
        parts.back().push_back(on_disc(at_horizon(arcs[i], here, arcs[i - 1], -before)));
      parts.back().push_back(on_disc(arcs[i]));
    } else if (before >= 0) {
      parts.back().push_back(on_disc(at_horizon(arcs[i - 1], before, arcs[i], -here)));
    }
  }
  return parts;
}

}  // namespace delone::io
