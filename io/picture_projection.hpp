#pragma once

#include <optional>
#include <vector>

#include "io/canvas.hpp"
#include "io/map_frame.hpp"
#include "io/mesh_points.hpp"
#include "io/picture.hpp"

namespace delone::io {

using CanvasLine = std::vector<CanvasPoint>;

/// Where the places of a picture come to lie on the canvas.
///
/// Lines are cut at the sides of the plot (with a margin, so that no cut shows) and at
/// the horizon of an orthographic view: a line may have several visible parts. Arcs are
/// subdivided until straight pieces look round.
class Projection {
 public:
  enum class Kind : std::uint8_t { plane, map, orthographic };

  /// Kind::plane or Kind::map.
  Projection(Kind kind, const MapFrame& frame, const CanvasBox& plot);
  /// The globe from above `centre`, filling the plot.
  Projection(stripack::LonLat centre, const CanvasBox& plot);

  /// Nothing if the place cannot be seen.
  [[nodiscard]] std::optional<CanvasPoint> place(const PicturePoint& p) const;
  [[nodiscard]] std::vector<CanvasLine> visible(const PictureLine& line) const;

 private:
  [[nodiscard]] SpacePoint direction(const PicturePoint& p) const;
  [[nodiscard]] CanvasPoint on_frame(double x, double y) const;
  [[nodiscard]] CanvasPoint on_disc(const SpacePoint& d) const;
  [[nodiscard]] double height(const SpacePoint& d) const;
  [[nodiscard]] std::vector<SpacePoint> subdivided(const PictureLine& line) const;
  [[nodiscard]] PictureLine unwrapped(const std::vector<SpacePoint>& arcs) const;
  void add_clipped(const PictureLine& line, double shift,
                   std::vector<CanvasLine>& parts) const;
  [[nodiscard]] std::vector<CanvasLine> on_near_side(
      const std::vector<SpacePoint>& arcs) const;

  Kind kind_;
  MapFrame frame_;
  CanvasBox plot_;
  SpacePoint up_{}, east_{}, north_{};
  double longest_piece_ = 0.04;  // of an arc, drawn straight; radians
};

}  // namespace delone::io
