#include "cli/picture_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace delone::cli {
namespace {

using Part = bool io::ShownParts::*;

const std::vector<Choice<Part>>& part_choices() {
  static const std::vector<Choice<Part>> choices{
      {"points", &io::ShownParts::points},
      {"polyline", &io::ShownParts::polyline},
      {"triangles", &io::ShownParts::triangles},
      {"voronoi", &io::ShownParts::voronoi},
      {"triangulated-voronoi", &io::ShownParts::spokes},
      {"circles", &io::ShownParts::circles}};
  return choices;
}

/// The words of "a,b,c".
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    words.push_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return words;
}

io::PictureOptions picture_options(const PictureSettings& settings,
                                   io::Mesh::Space space) {
  io::PictureOptions options;
  options.title = settings.title;
  options.width_px = settings.width_px;
  if (!settings.window.empty()) {
    const auto sides = parse_numbers("--window", settings.window, 4, 4);
    if (!(sides[0] < sides[1] && sides[2] < sides[3]))
      throw UsageError(
          fmt::format("--window '{}': W must be below E and S below N", settings.window));
    options.window = io::PictureWindow{sides[0], sides[1], sides[2], sides[3]};
  }
  if (settings.view.empty()) return options;
  if (space == io::Mesh::Space::plane)
    throw UsageError("--view looks at a globe; these points are in the plane (--on)");
  const auto place = parse_numbers("--view", settings.view, 2, 2);
  if (!(place[1] >= -90 && place[1] <= 90))
    throw UsageError(
        fmt::format("--view '{}': the latitude is outside -90..90", settings.view));
  options.view = stripack::LonLat{place[0], place[1]};
  return options;
}

}  // namespace

void add_picture_options(CLI::App& app, PictureSettings& settings) {
  app.add_option("--show", settings.show,
                 "Pictures: any of points, polyline, triangles, voronoi, "
                 "triangulated-voronoi, circles, separated by commas")
      ->type_name("WORDS");
  app.add_option("--labels", settings.labels,
                 "Pictures: number the nodes, triangles or all")
      ->type_name("WORD");
  app.add_option("--window", settings.window,
                 "Pictures: show this part only (default: all points)")
      ->type_name("W/E/S/N");
  app.add_option("--view", settings.view,
                 "Pictures: the globe from above this place (default: a map)")
      ->type_name("LON/LAT");
  app.add_option("--title", settings.title, "Pictures: title")->type_name("TEXT");
  app.add_option("--width", settings.width_px,
                 "Pictures: width in pixels (default: 1200)")
      ->type_name("N")
      ->check(CLI::Range(200, 10000));
}

io::ShownParts shown_parts(const PictureSettings& settings, const io::ShownParts& usual) {
  io::ShownParts parts = usual;
  if (!settings.show.empty())
    for (const auto& [word, part] : part_choices()) parts.*part = false;
  for (const std::string_view word : words_of(settings.show))
    parts.*parse_choice<Part>("--show", word, part_choices()) = true;
  enum class Labels { none, nodes, triangles, all };
  const auto labels = settings.labels.empty()
                          ? Labels::none
                          : parse_choice<Labels>("--labels", settings.labels,
                                                 {{"none", Labels::none},
                                                  {"nodes", Labels::nodes},
                                                  {"triangles", Labels::triangles},
                                                  {"all", Labels::all}});
  parts.node_labels = labels == Labels::nodes || labels == Labels::all;
  parts.cell_labels = labels == Labels::triangles || labels == Labels::all;
  return parts;
}

bool needs_triangles(const io::ShownParts& parts) {
  return parts.triangles || parts.voronoi || parts.spokes || parts.circles ||
         parts.cell_labels;
}

void draw_picture(const std::string& path, const io::Picture& picture,
                  const PictureSettings& settings, const std::string& format) {
  io::write_picture(path, picture, picture_options(settings, picture.space), format);
}

void draw_mesh(const std::string& path, const io::Mesh& mesh,
               const PictureSettings& settings, const io::ShownParts& parts,
               const std::string& format) {
  const io::PictureOptions options = picture_options(settings, mesh.space);
  io::write_picture(path, io::make_picture(mesh, parts), options, format);
}

}  // namespace delone::cli
