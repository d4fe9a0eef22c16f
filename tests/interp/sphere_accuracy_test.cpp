// The C1 surface on the sphere beside SSRFPACK's published figures; the whole table is
// printed by bench/sphere_accuracy.

#include <gtest/gtest.h>

#include <cmath>

#include "interp/c1_surface.hpp"
#include "interp/sphere_cases.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::sphere_cases;
using support::spiral;

double rms_error(const support::SphereCase& c, int num_nodes, const C1Options& options) {
  const auto nodes = spiral(num_nodes, 0), places = spiral(4000, 0.5);
  const SphereC1 surface(support::triangulated(nodes), sampled_on(c, nodes), options);
  const auto found = surface.values(places), truth = sampled_on(c, places);
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    sum += (found[i] - truth[i]) * (found[i] - truth[i]);
  return std::sqrt(sum / static_cast<double>(found.size()));
}

TEST(SphereAccuracy, OfFirstDegreeHarmonicsIsRounding) {
  EXPECT_LT(rms_error(sphere_cases[0], 100, {}), 1e-13);
  EXPECT_LT(rms_error(sphere_cases[0], 400, {}), 1e-14);
}

TEST(SphereAccuracy, IsAtLeastThatOfSsrfpackOnRoughFunctionsWithFewNodes) {
  const std::size_t s4 = 3, s5 = 4, s7 = 6, of_100 = 0, of_400 = 1;
  for (const auto& [number, k] :
       {std::pair{s4, of_100}, {s4, of_400}, {s5, of_100}, {s7, of_100}, {s7, of_400}}) {
    const auto& c = sphere_cases[number];
    EXPECT_LE(rms_error(c, support::spiral_counts[k], {}),
              std::min(c.local[k], c.global[k]))
        << c.name << " " << support::spiral_counts[k];
  }
}

TEST(SphereAccuracy, OfGlobalGradientsIsBetterOnSteepFunctions) {
  C1Options global;
  global.gradients = Gradients::global;
  global.tension = 0;
  const auto& s5 = sphere_cases[4];
  EXPECT_LT(rms_error(s5, 400, global), s5.global[1]);
  EXPECT_LT(rms_error(s5, 1600, global), 0.9 * s5.global[2]);
}

TEST(SphereAccuracy, OfLocalGradientsIsOfFourthOrder) {
  C1Options local;
  local.gradients = Gradients::local;
  local.tension = 0;
  for (const std::size_t number : {1U, 3U, 5U}) {
    const auto& c = sphere_cases[number];
    EXPECT_GT(rms_error(c, 400, local) / rms_error(c, 1600, local), 16) << c.name;
  }
}

}  // namespace
}  // namespace delone::interp
