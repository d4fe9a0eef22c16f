#include "interp/blend_operator_node.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "interp/blend_fit.hpp"
#include "interp/blend_mix.hpp"
#include "interp/blend_samples.hpp"
#include "interp/c1_surface.hpp"
#include "interp/plane_cells.hpp"
#include "interp/values.hpp"

namespace delone::interp {

namespace {

// Exponents of the weights of samples: softer ones than those of the surface that adapts
// to values, which let the nearest nodes decide, amplify values a third as much.
constexpr std::array soft_nearness{1.0, 0.5, 0.25};
constexpr double usual_nearness = 2;

/// A degree whose weights add up to no more than `full` counts in full, to more than
/// `most` not. Products of coefficients and terms that add up to more than `products`
/// lose too many digits.
struct MagnitudeLimits {
  double full, most, products;
};
constexpr MagnitudeLimits soft_limits{12, 24, 256}, usual_limits{200, 400, 1024};

/// Less of a degree is left out of a polynomial, as by fit_blend_model.
constexpr double least_part = 1e-6;
/// Terms that others span up to less than this are not determined.
constexpr double least_independence = 1e-7;

[[nodiscard]] Point2 on_surface(Point2 p) noexcept { return p; }
[[nodiscard]] Vector3 on_surface(Vector3 p) noexcept { return (1 / length(p)) * p; }
[[nodiscard]] Point2 plus(Point2 a, Point2 b) noexcept { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] Vector3 plus(Vector3 a, Vector3 b) noexcept { return a + b; }
[[nodiscard]] Point2 times(double s, Point2 a) noexcept { return {s * a.x, s * a.y}; }
[[nodiscard]] Vector3 times(double s, Vector3 a) noexcept { return s * a; }

/// A node with its stencil, without values.
template <BlendSpace Space, int Degree>
class Surroundings {
 public:
  using Triangulation = typename Space::Triangulation;
  using Vector = typename Space::Vector;
  using Terms = std::array<double, num_blend_terms(Degree)>;

  Surroundings(const Space& space, const Triangulation& triangulation, Site site,
               std::span<const StencilNode> stencil, double nearness,
               std::span<const double> site_values = {})
      : space_(space),
        triangulation_(&triangulation),
        site_(site),
        nearness_(nearness),
        center_(vector_of(site)),
        axes_(Space::axes(center_)) {
    double squared_radius = 0;
    for (const StencilNode& n : stencil)
      squared_radius = std::max(squared_radius, n.squared_distance);
    const double radius = radius_factor * std::sqrt(squared_radius);
    per_radius_ = 1 / radius;
    if (!(per_radius_ < std::numeric_limits<double>::max())) {
      per_radius_ = 0;
      return;
    }
    for (const StencilNode& n : stencil) {
      const double distance =
          std::max(std::sqrt(n.squared_distance) / radius, least_distance);
      const double ratio = (1 - distance) / distance;
      const double rise =
          site_values.empty() ? 0 : site_values[at(n.site)] - site_values[at(site)];
      samples_.add(terms_at(vector_of(n.site)), rise, std::pow(ratio, nearness),
                   n.is_neighbor);
    }
    samples_.factor();
  }

  /// 0: the stencil has no extent that a number can hold.
  [[nodiscard]] double per_radius() const noexcept { return per_radius_; }
  [[nodiscard]] double nearness() const noexcept { return nearness_; }
  [[nodiscard]] const BlendSamples<Degree>& samples() const noexcept { return samples_; }
  [[nodiscard]] BlendInfluence<Degree> influence(int degree) const {
    return samples_.influence(samples_.end_term(degree));
  }

  /// The largest sum of magnitudes of the weights that the polynomial of a degree takes
  /// in the triangles around; infinite where it is the small difference of large terms.
  [[nodiscard]] double magnitude(int degree, const MagnitudeLimits& limits) const {
    const BlendInfluence<Degree> x = influence(degree);
    double largest = 0;
    for_each_probe([&](const Vector& p) {
      // Not a number counts as too large.
      const double here =
          magnitude_at(terms_at(p), x, samples_.end_term(degree), limits.products);
      if (!(here <= largest)) largest = here;
      return largest <= limits.most;
    });
    return largest;
  }

 private:
  [[nodiscard]] Vector vector_of(Site s) const {
    return space_.vector(triangulation_->points()[at(s)]);
  }
  [[nodiscard]] Terms terms_at(const Vector& p) const {
    return model_terms<Degree>(
        Space::local(axes_, Space::position(Space::difference(p, center_)), per_radius_));
  }

  [[nodiscard]] double magnitude_at(const Terms& terms, const BlendInfluence<Degree>& x,
                                    std::size_t num_terms, double most_products) const {
    double sum = 0, magnitude = 0, of_products = 0;
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      double weight = 0;
      for (std::size_t c = 0; c < num_terms; ++c) {
        weight += terms[c] * x[c][r];
        of_products += std::abs(terms[c] * x[c][r]);
      }
      sum += weight;
      magnitude += std::abs(weight);
    }
    if (!(of_products < most_products)) return std::numeric_limits<double>::infinity();
    return magnitude + std::abs(1 - sum);
  }

  // As long as f says so: the middles of edges and triangles around. Towards the
  // neighbours themselves the polynomial does not count.
  template <class F>
  void for_each_probe(F f) const {
    const Adjacency& t = triangulation_->adjacency();
    Arc a = t.first_arc(site_);
    for (std::int32_t i = 0; i < t.degree(site_); ++i, a = t.next(a)) {
      const Vector to = vector_of(t.target(a));
      if (!f(on_surface(times(0.5, plus(center_, to))))) return;
      if (!t.has_left(a)) continue;
      const Vector third = vector_of(t.left(a)[2]);
      if (!f(on_surface(times(1.0 / 3, plus(center_, plus(to, third)))))) return;
    }
  }

  Space space_;
  const Triangulation* triangulation_;
  Site site_;
  double nearness_;
  Vector center_;
  typename Space::Axes axes_;
  double per_radius_ = 0;
  BlendSamples<Degree> samples_;
};

/// How much a degree may count, 0 .. 1.
template <BlendSpace Space, int Degree>
double trust_in(const Surroundings<Space, Degree>& around, int degree,
                const MagnitudeLimits& limits) {
  if (around.per_radius() == 0 ||
      around.samples().size() < BlendSamples<Degree>::end_term(degree))
    return 0;
  for (int d = 1; d <= degree; ++d)
    if (!(around.samples().independence(d) >= least_independence)) return 0;
  const double magnitude = around.magnitude(degree, limits);
  if (!(magnitude < limits.most)) return 0;
  return std::min(1.0, (limits.most - magnitude) / (limits.most - limits.full));
}

/// The parts of degrees that are wanted, as far as they can be trusted; what is left goes
/// to the next lower one.
template <BlendSpace Space, int Degree>
C1NodeChoice trusted(const Surroundings<Space, Degree>& around,
                     const std::array<double, Degree + 1>& wanted,
                     const MagnitudeLimits& limits, double least_tension) {
  C1NodeChoice choice;
  choice.nearness = around.nearness();
  double left = 0;
  for (int degree = Degree; degree >= 1; --degree) {
    const auto d = static_cast<std::size_t>(degree);
    const double whole = wanted[d] + left;
    // What is left out of the polynomial need not be trusted.
    choice.parts[d] =
        whole < least_part ? whole : whole * trust_in(around, degree, limits);
    left = whole - choice.parts[d];
  }
  choice.parts[0] = wanted[0] + left;
  choice.tension = std::min(
      most_tension, least_tension + (1 - least_tension) * std::sqrt(choice.parts[0]));
  return choice;
}

/// What fit_blend_model would mix for the values.
template <int Degree>
std::array<double, Degree + 1> wanted_by_values(const BlendSamples<Degree>& samples,
                                                double doubt) {
  std::array<double, Degree + 1> errors = samples.errors();
  if (!(errors[0] > 0)) return {1};
  if (samples.size() == 2) errors[1] = 0;
  return mix_degrees(errors, doubt);
}

/// `choose(site, stencil)` for every site.
template <BlendSpace Space, int Degree, class Choose>
std::vector<C1NodeChoice> for_all_nodes(const Space& space,
                                        const typename Space::Triangulation& t,
                                        const RunOptions& run, Choose choose) {
  constexpr std::int64_t chunk = 512;
  std::vector<C1NodeChoice> result(at(t.num_sites()));
  if (t.dimension() < 2) return result;
  delaunay::parallel_chunks(
      t.num_sites(), chunk, run, [&](std::int64_t first, std::int64_t last) {
        StencilGatherer<Space> gatherer(space, t);
        for (auto s = static_cast<Site>(first); s < last; ++s)
          result[at(s)] = choose(s, gatherer.around(s, num_nearest(Degree)));
      });
  return result;
}

template <BlendSpace Space, int Degree>
std::vector<C1NodeChoice> from_geometry(const Space& space,
                                        const typename Space::Triangulation& t,
                                        double tension, const RunOptions& run) {
  std::array<double, Degree + 1> wanted{};
  wanted.back() = 1;
  return for_all_nodes<Space, Degree>(
      space, t, run, [&](Site s, std::span<const StencilNode> stencil) {
        C1NodeChoice best;
        for (const double nearness : soft_nearness) {
          const Surroundings<Space, Degree> around(space, t, s, stencil, nearness);
          const C1NodeChoice choice = trusted(around, wanted, soft_limits, tension);
          if (nearness == soft_nearness.front() ||
              choice.parts[Degree] > best.parts[Degree])
            best = choice;
          if (best.parts[Degree] == 1) break;
        }
        return best;
      });
}

template <BlendSpace Space, int Degree>
std::vector<C1NodeChoice> from_values(const Space& space,
                                      const typename Space::Triangulation& t,
                                      std::span<const double> site_values,
                                      const Stiffness& stiffness, const RunOptions& run) {
  return for_all_nodes<Space, Degree>(
      space, t, run, [&](Site s, std::span<const StencilNode> stencil) {
        const Surroundings<Space, Degree> around(space, t, s, stencil, usual_nearness,
                                                 site_values);
        if (around.per_radius() == 0) return C1NodeChoice{};
        return trusted(around, wanted_by_values(around.samples(), stiffness.doubt),
                       usual_limits, stiffness.tension);
      });
}

template <BlendSpace Space>
std::shared_ptr<const C1Choices> all_choices(const Space& space,
                                             const typename Space::Triangulation& t,
                                             const C1Options& options,
                                             const RunOptions& run) {
  check(options);
  check_linear(options);
  const double tension = options.tension.value_or(0);
  return std::make_shared<const C1Choices>(
      C1Choices{options.degree, options.degree == FitDegree::quartic
                                    ? from_geometry<Space, 4>(space, t, tension, run)
                                    : from_geometry<Space, 3>(space, t, tension, run)});
}

/// The stiffness that a surface chose, known by its tension.
Stiffness stiffness_taken(const C1Options& options, const C1Fit& fit) {
  if (options.tension) return stiffness_of(*options.tension);
  Stiffness stiffness;
  for (std::size_t level = 0; level < num_stiffness_levels; ++level)
    if (stiffness_levels[level].tension == fit.tension)
      stiffness = stiffness_levels[level];
  return stiffness;
}

template <BlendSpace Space, class Surface>
std::shared_ptr<const C1Choices> choices_of(
    const Space& space, const std::shared_ptr<const typename Space::Triangulation>& t,
    std::span<const double> row_values, C1Options options, const RunOptions& run) {
  options.choices = {};
  options.gradients = Gradients::local;
  const Stiffness stiffness =
      stiffness_taken(options, Surface(t, row_values, options, run).fit());
  const std::vector<double> values =
      values_at_sites(t->sites(), t->num_sites(), row_values, options.duplicates);
  return std::make_shared<const C1Choices>(C1Choices{
      options.degree, options.degree == FitDegree::quartic
                          ? from_values<Space, 4>(space, *t, values, stiffness, run)
                          : from_values<Space, 3>(space, *t, values, stiffness, run)});
}

}  // namespace

void check_linear(const C1Options& options) {
  if (options.bounds == Bounds::local) {
    throw Error(
        "a surface with local bounds is not linear in the data, so it has no fixed "
        "choices "
        "and no operator; leave the bounds out");
  }
  if (options.gradients == Gradients::global || options.gradients == Gradients::given)
    throw Error("fixed choices and operators are of local gradients; ask for these");
}

void check_choices(const C1Options& options, Site num_sites) {
  if (!options.choices) return;
  check_linear(options);
  const C1Choices& choices = *options.choices;
  if (choices.degree != options.degree)
    throw Error("the choices are for another degree of fits; give both the same");
  if (choices.nodes.size() != at(num_sites)) {
    throw Error("there are " + std::to_string(choices.nodes.size()) + " choices for " +
                std::to_string(num_sites) + " positions; make them for these points");
  }
  if (options.tension)
    throw Error("fixed choices hold the tension; make them with it instead");
  for (const C1NodeChoice& node : choices.nodes) {
    const double sum = std::accumulate(node.parts.begin(), node.parts.end(), 0.0);
    if (!(std::abs(sum - 1) < 1e-9) || !(node.tension >= 0 && node.tension < 1) ||
        !(node.nearness > 0 && node.nearness <= 4))
      throw Error(
          "a choice has parts that do not sum to one, or a tension outside 0 .. 1");
  }
}

template <int Degree>
BlendModel<Degree> BlendNode<Degree>::model(Site node,
                                            std::span<const double> site_values) const {
  BlendModel<Degree> result;
  result.value = site_values[at(node)];
  result.per_radius = per_radius;
  result.least = -std::numeric_limits<double>::infinity();
  result.most = std::numeric_limits<double>::infinity();
  result.tension = tension;
  for (std::size_t c = 0; c < result.coefficients.size(); ++c) {
    for (std::size_t k = 0; k < sites.size(); ++k) {
      result.coefficients[c] +=
          weights_of(c)[k] * (site_values[at(sites[k])] - result.value);
    }
  }
  return result;
}

template <BlendSpace Space, int Degree>
BlendNode<Degree> blend_node(const Space& space,
                             const typename Space::Triangulation& triangulation,
                             Site site, std::span<const StencilNode> stencil,
                             const C1NodeChoice& choice) {
  const Surroundings<Space, Degree> around(space, triangulation, site, stencil,
                                           choice.nearness);
  BlendNode<Degree> node;
  node.per_radius = around.per_radius();
  node.tension = choice.tension;
  if (node.per_radius == 0 || choice.parts[0] == 1) return node;
  for (const StencilNode& n : stencil) node.sites.push_back(n.site);
  node.weights.resize(num_blend_terms(Degree) * stencil.size());
  for (int degree = 1; degree <= Degree; ++degree) {
    const double part = choice.parts[static_cast<std::size_t>(degree)];
    if (part < least_part) continue;
    const BlendInfluence<Degree> x = around.influence(degree);
    for (std::size_t c = 0; c < around.samples().end_term(degree); ++c) {
      for (std::size_t k = 0; k < stencil.size(); ++k)
        node.weights[c * stencil.size() + k] += part * x[c][k];
    }
  }
  return node;
}

std::shared_ptr<const C1Choices> c1_choices(const tripack::Triangulation& triangulation,
                                            const C1Options& options,
                                            const RunOptions& run) {
  return all_choices(PlaneSpace{coordinate_scale(triangulation.points())}, triangulation,
                     options, run);
}

std::shared_ptr<const C1Choices> c1_choices(const stripack::Triangulation& triangulation,
                                            const C1Options& options,
                                            const RunOptions& run) {
  return all_choices(SphereSpace{}, triangulation, options, run);
}

std::shared_ptr<const C1Choices> c1_choices(
    const std::shared_ptr<const tripack::Triangulation>& triangulation,
    std::span<const double> row_values, const C1Options& options, const RunOptions& run) {
  return choices_of<PlaneSpace, PlaneC1>({coordinate_scale(triangulation->points())},
                                         triangulation, row_values, options, run);
}

std::shared_ptr<const C1Choices> c1_choices(
    const std::shared_ptr<const stripack::Triangulation>& triangulation,
    std::span<const double> row_values, const C1Options& options, const RunOptions& run) {
  return choices_of<SphereSpace, SphereC1>({}, triangulation, row_values, options, run);
}

template struct BlendNode<3>;
template struct BlendNode<4>;

template BlendNode<3> blend_node<PlaneSpace, 3>(const PlaneSpace&,
                                                const tripack::Triangulation&, Site,
                                                std::span<const StencilNode>,
                                                const C1NodeChoice&);
template BlendNode<4> blend_node<PlaneSpace, 4>(const PlaneSpace&,
                                                const tripack::Triangulation&, Site,
                                                std::span<const StencilNode>,
                                                const C1NodeChoice&);
template BlendNode<3> blend_node<SphereSpace, 3>(const SphereSpace&,
                                                 const stripack::Triangulation&, Site,
                                                 std::span<const StencilNode>,
                                                 const C1NodeChoice&);
template BlendNode<4> blend_node<SphereSpace, 4>(const SphereSpace&,
                                                 const stripack::Triangulation&, Site,
                                                 std::span<const StencilNode>,
                                                 const C1NodeChoice&);

}  // namespace delone::interp
