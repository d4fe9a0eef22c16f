// Errors of the C1 surface on the sphere beside those of SSRFPACK: seven functions on a
// spiral of nodes, evaluated on the same spiral turned by half a radian.
//
// sphere_accuracy [choices]: with `choices` also for local and global gradients without
// tension and for polynomials of fourth degree.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "interp/c1_surface.hpp"
#include "interp/sphere_cases.hpp"

namespace {

using delone::interp::C1Options;
using delone::interp::Gradients;
using delone::interp::SphereC1;
using delone::stripack::Direction;
using delone::stripack::Triangulation;
using delone::support::sampled_on;
using delone::support::sphere_cases;
using delone::support::SphereCase;
using delone::support::spiral;
using delone::support::spiral_counts;

struct Errors {
  double largest = 0, rms = 0;
};
Errors errors_of(std::span<const double> found, std::span<const double> truth) {
  Errors e;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double d = std::abs(found[i] - truth[i]);
    e.largest = std::max(e.largest, d);
    e.rms += d * d / static_cast<double>(found.size());
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

struct Choice {
  const char* name;
  C1Options options;
};

std::vector<Choice> choices(bool wants_all) {
  std::vector<Choice> result{{"default", {}}};
  if (!wants_all) return result;
  C1Options local, global, quartic;
  local.tension = global.tension = quartic.tension = 0;
  local.gradients = quartic.gradients = Gradients::local;
  global.gradients = Gradients::global;
  quartic.degree = delone::interp::FitDegree::quartic;
  result.push_back({"local", local});
  result.push_back({"global", global});
  result.push_back({"quartic", quartic});
  return result;
}

void print_row(const SphereCase& c, std::size_t k, const Choice& choice,
               const SphereC1& surface, const Errors& e, double order) {
  const double best = std::min(c.local[k], c.global[k]), ratio = e.rms / best;
  std::printf("| %s | %d | %s | %.3e / %.3e | %.3e | %.3e | %.3f%s | ", c.name,
              spiral_counts[k], choice.name, e.largest, e.rms, c.local[k], c.global[k],
              ratio, ratio > asked(c) ? " *" : "");
  if (order > 0) std::printf("%.2f", order);
  const auto& fit = surface.fit();
  std::printf(" | %s, %.2g |\n", fit.gradients == Gradients::global ? "global" : "local",
              fit.tension);
}

void measure(const SphereCase& c, const Choice& choice,
             std::span<const Direction> places) {
  const std::vector<double> truth = sampled_on(c, places);
  double before = 0;
  for (std::size_t k = 0; k < spiral_counts.size(); ++k) {
    const std::vector<Direction> nodes = spiral(spiral_counts[k], 0);
    const auto t = std::make_shared<const Triangulation>(nodes);
    const SphereC1 surface(t, sampled_on(c, nodes), choice.options);
    const Errors e = errors_of(surface.values(places), truth);
    print_row(c, k, choice, surface, e, before > 0 ? std::log2(before / e.rms) : 0);
    before = e.rms;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool wants_all = argc > 1 && std::strcmp(argv[1], "choices") == 0;
  const std::vector<Direction> places = spiral(20000, 0.5);
  std::printf(
      "| f | nodes | choice | largest / RMS | GRADL | GRADG | of the better | order | "
      "gradients, tension |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const SphereCase& c : sphere_cases)
    for (const Choice& choice : choices(wants_all)) measure(c, choice, places);
}
