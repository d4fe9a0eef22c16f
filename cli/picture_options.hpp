#pragma once

#include <optional>
#include <string>

#include "cli/options.hpp"
#include "io/mesh.hpp"
#include "io/picture_layers.hpp"

namespace delone::cli {

/// How a picture of points, triangles or cells looks.
struct PictureSettings {
  std::string show;  ///< words with commas; empty: what the subcommand is about
  std::string labels, window, view, title;
  int width_px = 1200;
};

/// --show, --labels, --window, --view, --title, --width.
void add_picture_options(CLI::App& app, PictureSettings& settings);

/// The parts that --show and --labels name, or else `usual`. Throws UsageError.
[[nodiscard]] io::ShownParts shown_parts(const PictureSettings& settings,
                                         const io::ShownParts& usual);

/// Does --show ask for what needs triangles?
[[nodiscard]] bool needs_triangles(const io::ShownParts& parts);

/// Draws a picture. Throws UsageError if --view is given for the plane.
void draw_picture(const std::string& path, const io::Picture& picture,
                  const PictureSettings& settings, const std::string& format);

/// Draws the mesh. Throws UsageError if --view is given for the plane.
void draw_mesh(const std::string& path, const io::Mesh& mesh,
               const PictureSettings& settings, const io::ShownParts& parts,
               const std::string& format);

}  // namespace delone::cli
