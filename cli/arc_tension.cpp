#include "cli/arc_tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "cli/output.hpp"

namespace delone::cli {
namespace {

using interp::ArcShape;

const std::vector<Choice<ArcShape>> shape_choices{{"monotone", ArcShape::monotone},
                                                  {"convex", ArcShape::convex}};

std::optional<double> parse_number(std::string_view text) {
  double number = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return number;
}

void parse_range(const std::string& text, ArcTensionSettings& settings) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto least = parse_number(std::string_view(text).substr(0, slash)),
               most = parse_number(std::string_view(text).substr(slash + 1));
    if (least && most && *least <= *most) {
      settings.demand.least = *least;
      settings.demand.most = *most;
      settings.is_given = settings.has_range = true;
      return;
    }
  }
  throw UsageError(
      fmt::format("--range takes LEAST/MOST, such as 0/100 or 0/inf, not '{}'", text));
}

}  // namespace

void add_arc_tension_options(CLI::App& app, SurfaceSettings& settings) {
  ArcTensionSettings& arcs = settings.arcs;
  add_choice<ArcShape>(
      app, "--shape", arcs.demand.shape, shape_choices,
      "c1: along every edge of the triangulation monotone where its ends are; convex: "
      "and bent one way only where they are (tension splines over the edges)");
  app.add_option_function<std::string>(
         "--range", [&arcs](const std::string& text) { parse_range(text, arcs); },
         "c1: along every edge of the triangulation values stay between these, which "
         "must hold all data; 0/inf: not negative (default: the data's range, widened "
         "by a quarter)")
      ->type_name("LEAST/MOST");
  const auto set_factor = [&arcs](const double& factor) {
    if (!(factor >= 0 && factor <= interp::tension_factor_max)) {
      throw UsageError(fmt::format(
          "--arc-tension takes a number from 0 (cubics over the edges) to {} (next to "
          "straight)",
          interp::tension_factor_max));
    }
    arcs.factor = factor;
    arcs.is_given = true;
  };
  app.add_option_function<double>(
         "--arc-tension", set_factor,
         "c1: tension splines over the edges, with at least this factor: 0 (cubics) to "
         "85 (next to straight)")
      ->type_name("FACTOR");
}

void check_arc_tension(const SurfaceSettings& settings) {
  if (!settings.arcs.is_wanted()) return;
  constexpr std::string_view what = "--shape, --range and --arc-tension";
  if (settings.method != Method::c1) {
    throw UsageError(
        fmt::format("{} are for --method c1, not {}", what, name_of(settings.method)));
  }
  const std::string_view other = settings.tension      ? "--tension"
                                 : settings.is_bounded ? "--bounded"
                                 : settings.degree != interp::FitDegree::cubic
                                     ? "--fit-degree 4"
                                     : "";
  check_arc_tension_without(other, settings);
}

void check_arc_tension_without(std::string_view other, const SurfaceSettings& settings) {
  if (other.empty() || !settings.arcs.is_wanted()) return;
  throw UsageError(fmt::format(
      "--shape, --range and --arc-tension do not go with {}; leave out one of them",
      other));
}

interp::TensionSplineOptions tension_spline_options(const interp::C1Options& c1,
                                                    const ArcTensionSettings& settings,
                                                    const std::vector<double>& values) {
  interp::TensionSplineOptions options{c1, settings.demand, settings.factor, {}};
  if (settings.has_range || values.empty()) return options;
  const auto [least, most] = std::ranges::minmax_element(values);
  const double wider = 0.25 * (*most - *least);
  options.demand.least = *least - wider;
  options.demand.most = *most + wider;
  return options;
}

void say_arc_tension(const interp::TensionSplineFit& fit, const Reporter& reporter) {
  std::string more;
  if (fit.num_limited > 0) {
    more += fmt::format("; {} would take more than {}", counted(fit.num_limited, "edge"),
                        interp::tension_factor_max);
  }
  if (fit.num_shortened > 0) {
    more += fmt::format("; {} shortened to stay in the range",
                        counted(fit.num_shortened, "gradient"));
  }
  reporter.say("c1: {} of {} tightened, largest factor {:.3g}{}", fit.num_tightened,
               counted(fit.num_arcs, "edge"), fit.largest, more);
}

}  // namespace delone::cli
