#include "interp/rim_extension.hpp"

namespace delone::interp {

namespace {

// How far p is past `corner` along the edge from a to b, one of which it is; only the
// sign counts.
double past(Vector3 corner, Vector3 a, Vector3 b, Vector3 p) noexcept {
  const Vector3 along = cross(cross(a, b - a), corner);
  return dot(along, p - corner);
}

double arc_length(Vector3 a, Vector3 b) noexcept {
  return 2 * std::atan2(length(b - a), length(a + b));
}

}  // namespace

RimExtension::RimExtension(const stripack::Triangulation& t,
                           std::span<const double> site_values) {
  if (t.dimension() == 2) {
    follow_boundary(t);
  } else {
    follow_chain(t);
  }
  for (const Site s : sites_) points_.push_back(vector(t.points()[at(s)]));
  make_boxes();
  far_value_ = sites_.empty() ? 0 : mean_along(site_values);
}

void RimExtension::follow_boundary(const stripack::Triangulation& t) {
  const Adjacency& adjacency = t.adjacency();
  Site first = 0;
  while (first < t.num_sites() && !adjacency.is_boundary(first)) ++first;
  if (first == t.num_sites()) return;
  Site s = first;
  do {
    sites_.push_back(s);
    arcs_.push_back(adjacency.first_arc(s));
    s = adjacency.target(arcs_.back());
  } while (s != first);
}

// Sites of a chain are numbered along it.
void RimExtension::follow_chain(const stripack::Triangulation& t) {
  for (Site s = 0; s < t.num_sites(); ++s) sites_.push_back(s);
  arcs_.resize(sites_.size());
  const auto around = t.adjacency().neighbors(0);
  is_closed_ =
      t.num_sites() > 2 && std::ranges::find(around, t.num_sites() - 1) != around.end();
}

void RimExtension::make_boxes() {
  box_size_ = std::max<std::size_t>(
      8, static_cast<std::size_t>(std::sqrt(static_cast<double>(points_.size()))));
  for (std::size_t begin = 0; begin < points_.size(); begin += box_size_)
    boxes_.push_back(box_of(begin, std::min(points_.size(), begin + box_size_)));
}

RimExtension::Box RimExtension::box_of(std::size_t begin,
                                       std::size_t end) const noexcept {
  Box box{points_[begin], points_[begin]};
  double bulge = 0;  // of an arc above its chord
  for (std::size_t i = begin; i < end; ++i) {
    const Vector3 a = points_[i], b = points_[(i + 1) % points_.size()],
                  d = 0.5 * (b - a);
    bulge = std::max(bulge, 1 - std::sqrt(std::max(0.0, 1 - dot(d, d))));
    for (const Vector3& p : {a, b}) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y),
                 std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y),
                  std::max(box.high.z, p.z)};
    }
  }
  bulge += 0x1p-50;
  const Vector3 margin{bulge, bulge, bulge};
  return {box.low - margin, box.high + margin};
}

// Above the value of the first site, so that constants come out exactly.
double RimExtension::mean_along(std::span<const double> site_values) const noexcept {
  const double base = site_values[at(sites_[0])];
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < num_edges(); ++i) {
    const std::size_t next = (i + 1) % sites_.size();
    const double size = arc_length(points_[i], points_[next]);
    sum += size * (0.5 * (site_values[at(sites_[i])] - base) +
                   0.5 * (site_values[at(sites_[next])] - base));
    total += size;
  }
  return total > 0 ? base + sum / total : base;
}

double RimExtension::Box::squared_distance(Vector3 p) const noexcept {
  const auto apart = [](double a, double least, double most) {
    return std::max({least - a, 0.0, a - most});
  };
  const Vector3 d{apart(p.x, low.x, high.x), apart(p.y, low.y, high.y),
                  apart(p.z, low.z, high.z)};
  return dot(d, d);
}

// By chords, which tell nodes a millimetre apart.
RimExtension::Reached RimExtension::reached(std::size_t i, Vector3 p) const noexcept {
  const std::size_t next = (i + 1) % sites_.size();
  const Vector3 a = points_[i], b = points_[next];
  const auto at_corner = [&](std::size_t k) {
    const Vector3 d = p - points_[k];
    const bool has_next = is_closed_ || k + 1 < sites_.size();
    return Reached{
        dot(d, d),
        {RimPlace::Kind::corner, sites_[k],
         has_next && sites_.size() > 1 ? sites_[(k + 1) % sites_.size()] : none,
         arcs_[k]}};
  };
  if (i >= num_edges() || !(past(a, a, b, p) > 0)) return at_corner(i);
  if (!(past(b, a, b, p) < 0)) return at_corner(next);
  const Vector3 across = cross(a, b - a);
  const double height = dot(across, p - a) / length(across), squared = height * height;
  return {2 * squared / (1 + std::sqrt(std::max(0.0, 1 - squared))),
          {RimPlace::Kind::edge, sites_[i], sites_[next], arcs_[i]}};
}

RimPlace RimExtension::nearest(const Direction& direction) const noexcept {
  const Vector3 p = vector(direction);
  Reached best{2, {}};
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    if (boxes_[k].squared_distance(p) > best.squared_chord) continue;
    const std::size_t end = std::min(points_.size(), (k + 1) * box_size_);
    for (std::size_t i = k * box_size_; i < end; ++i) {
      const Reached found = reached(i, p);
      if (found.squared_chord < best.squared_chord) best = found;
    }
  }
  return best.place;
}

}  // namespace delone::interp
