#include "io/weights_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "io/grid_samples.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::content_of;
using test::Doubles;
using test::message_of;
using test::NetcdfMaker;
using test::TemporaryFolder;

std::shared_ptr<const tripack::Triangulation> triangle() {
  return std::make_shared<const tripack::Triangulation>(
      std::vector<tripack::Point2>{{0, 0}, {2, 0}, {0, 2}});
}

// Three observations, a grid of 3 x 2 targets of which one is outside.
WeightsFile small_weights() {
  const interp::Grid grid = interp::plane_grid({0, 2, 0, 1}, interp::NodeCounts{3, 2});
  WeightsFile file{.weights =
                       interp::linear_operator(triangle(), interp::plane_nodes(grid))};
  file.source = {.x = {0, 2, 0}, .y = {0, 0, 2}, .units = "m"};
  file.target = weights_side(grid, Mesh::Space::plane);
  file.target.units = "m";
  file.title = "a test";
  return file;
}

void expect_same_matrix(const interp::Operator& a, const interp::Operator& b) {
  ASSERT_EQ(a.matrix().rows(), b.matrix().rows());
  ASSERT_EQ(a.matrix().cols(), b.matrix().cols());
  ASSERT_EQ(a.matrix().nonZeros(), b.matrix().nonZeros());
  for (Eigen::Index i = 0; i <= a.matrix().rows(); ++i)
    EXPECT_EQ(a.matrix().outerIndexPtr()[i], b.matrix().outerIndexPtr()[i]);
  for (Eigen::Index k = 0; k < a.matrix().nonZeros(); ++k) {
    EXPECT_EQ(a.matrix().innerIndexPtr()[k], b.matrix().innerIndexPtr()[k]);
    EXPECT_EQ(a.matrix().valuePtr()[k], b.matrix().valuePtr()[k]);
  }
}

TEST(WeightsFile, IsReadBackBitForBit) {
  const TemporaryFolder folder;
  const WeightsFile file = small_weights();
  write_weights(folder.path("a.nc"), file);
  const WeightsFile back = read_weights(folder.path("a.nc"));
  expect_same_matrix(back.weights, file.weights);
  EXPECT_EQ(back.source.x, file.source.x);
  EXPECT_EQ(back.source.y, file.source.y);
  EXPECT_EQ(back.target.x, file.target.x);
  EXPECT_EQ(back.target.y, file.target.y);
  EXPECT_EQ(back.target.shape, (std::vector<std::int32_t>{3, 2}));
  EXPECT_TRUE(back.source.shape.empty());
  EXPECT_EQ(back.source.space, Mesh::Space::plane);
  EXPECT_EQ(back.source.units, "m");
  EXPECT_EQ(back.fraction, (Doubles{1, 1, 1, 1, 1, 0}));
  EXPECT_EQ(back.title, "a test");
  EXPECT_EQ(back.map_method, "linear");
  EXPECT_EQ(back.normalization, "destarea");
}

TEST(WeightsFile, OfTheGlobeHasDegreesAndMasks) {
  const TemporaryFolder folder;
  WeightsFile file = small_weights();
  file.source.space = file.target.space = Mesh::Space::globe;
  file.source.mask = {1, 0, 1};
  file.fraction = {0.5, 1, 1, 1, 1, 0};
  write_weights(folder.path("a.nc"), file);
  const WeightsFile back = read_weights(folder.path("a.nc"));
  EXPECT_EQ(back.source.space, Mesh::Space::globe);
  EXPECT_EQ(back.source.mask, (std::vector<std::int32_t>{1, 0, 1}));
  EXPECT_EQ(back.fraction[0], 0.5);
}

TEST(WeightsFile, InTheLayoutOfScripIsReadBackWithItsMethod) {
  const TemporaryFolder folder;
  WeightsFile file = small_weights();
  file.source.space = file.target.space = Mesh::Space::globe;
  file.map_method = "c1";
  write_weights(folder.path("a.nc"), file, WeightsLayout::scrip);
  const WeightsFile back = read_weights(folder.path("a.nc"));
  expect_same_matrix(back.weights, file.weights);
  EXPECT_EQ(back.source.x, file.source.x);
  EXPECT_EQ(back.target.y, file.target.y);
  EXPECT_EQ(back.target.shape, (std::vector<std::int32_t>{3, 2}));
  EXPECT_EQ(back.fraction, (Doubles{1, 1, 1, 1, 1, 0}));
  EXPECT_EQ(back.map_method, "c1");
}

TEST(WeightsFile, InTheLayoutOfScripIsOfTheGlobe) {
  const TemporaryFolder folder;
  EXPECT_NE(message_of<Error>([&] {
              write_weights(folder.path("a.nc"), small_weights(), WeightsLayout::scrip);
            }).find("ESMF"),
            std::string::npos);
  EXPECT_TRUE(folder.names().empty());
}

TEST(WeightsFile, CellsOfAGridReachHalfAStepAndUpToThePoles) {
  const interp::Grid grid = interp::globe_grid({0, 90, -90, 90}, interp::Spacing{45, 90});
  const WeightsSide side = weights_side(grid, Mesh::Space::globe);
  ASSERT_EQ(side.x.size(), 9u);
  ASSERT_EQ(side.corner_x.size(), 36u);
  EXPECT_EQ(Doubles(side.corner_x.begin(), side.corner_x.begin() + 4),
            (Doubles{-22.5, 22.5, 22.5, -22.5}));
  EXPECT_EQ(Doubles(side.corner_y.begin(), side.corner_y.begin() + 4),
            (Doubles{-90, -90, -45, -45}));
  EXPECT_EQ(Doubles(side.corner_y.end() - 4, side.corner_y.end()),
            (Doubles{45, 45, 90, 90}));
}

TEST(WeightsFile, GivesTheSameBytesForTheSameWeights) {
  const TemporaryFolder folder;
  write_weights(folder.path("a.nc"), small_weights());
  write_weights(folder.path("b.nc"), small_weights());
  EXPECT_EQ(content_of(folder.path("a.nc")), content_of(folder.path("b.nc")));
  EXPECT_EQ(folder.names().size(), 2u);  // no temporary file is left
}

TEST(WeightsFile, WithoutWeightsOrCoordinatesIsReadBack) {
  const TemporaryFolder folder;
  const std::vector<tripack::Point2> outside{{9, 9}, {8, 8}};
  write_weights(folder.path("a.nc"),
                {.weights = interp::linear_operator(triangle(), outside)});
  const WeightsFile back = read_weights(folder.path("a.nc"));
  EXPECT_EQ(back.weights.matrix().rows(), 2);
  EXPECT_EQ(back.weights.matrix().cols(), 3);
  EXPECT_EQ(back.weights.matrix().nonZeros(), 0);
  EXPECT_TRUE(back.target.x.empty());
}

TEST(WeightsFile, RefusesSidesThatDoNotFitTheOperator) {
  const TemporaryFolder folder;
  const auto attempt = [&](auto change) {
    WeightsFile file = small_weights();
    change(file);
    return message_of<Error>([&] { write_weights(folder.path("a.nc"), file); });
  };
  EXPECT_NE(attempt([](WeightsFile& f) { f.source.x.pop_back(); }), "nothing thrown");
  EXPECT_NE(attempt([](WeightsFile& f) { f.source.y.clear(); }), "nothing thrown");
  EXPECT_NE(attempt([](WeightsFile& f) { f.target.shape = {6, 2}; }), "nothing thrown");
  EXPECT_NE(attempt([](WeightsFile& f) { f.target.shape = {-3, -2}; }), "nothing thrown");
  EXPECT_NE(attempt([](WeightsFile& f) { f.target.mask = {1}; }), "nothing thrown");
  EXPECT_NE(attempt([](WeightsFile& f) { f.fraction = {1}; }), "nothing thrown");
  EXPECT_TRUE(folder.names().empty());
}

// What a file of another program says, entry by entry.
struct Entries {
  Doubles target{1, 2, 1}, source{3, 1, 1}, weight{0.25, 1, 0.75};
  std::size_t num_sources = 3, num_targets = 2;
};

std::string put_esmf(const TemporaryFolder& folder, const Entries& entries) {
  const std::string path = folder.path("esmf.nc");
  NetcdfMaker maker(path);
  const int a = maker.dimension("n_a", entries.num_sources),
            b = maker.dimension("n_b", entries.num_targets),
            s = maker.dimension("n_s", entries.weight.size()),
            t = maker.dimension("n_t", entries.target.size());
  const int y = maker.variable("yc_a", {a}), x = maker.variable("xc_a", {a}),
            f = maker.variable("frac_b", {b}), row = maker.variable("row", {t}, NC_INT),
            col = maker.variable("col", {s}, NC_INT), weight = maker.variable("S", {s});
  maker.text(x, "units", "degrees");
  maker.text(y, "units", "degrees");
  maker.put(x, Doubles(entries.num_sources, 10));
  maker.put(y, Doubles(entries.num_sources, 20));
  maker.put(f, Doubles(entries.num_targets, 1));
  maker.put(row, entries.target);
  maker.put(col, entries.source);
  maker.put(weight, entries.weight);
  return path;
}

TEST(ReadWeights, TakesEntriesInAnyOrderAndSumsThoseOfOnePair) {
  const TemporaryFolder folder;
  const WeightsFile file = read_weights(put_esmf(
      folder,
      {.target = {2, 1, 1, 1}, .source = {1, 3, 1, 3}, .weight = {1, 0.25, 0.5, 0.25}}));
  EXPECT_EQ(file.weights.matrix().nonZeros(), 3);
  EXPECT_EQ(file.weights.apply(Doubles{1, 10, 100}), (Doubles{50.5, 1}));
  EXPECT_EQ(file.source.space, Mesh::Space::globe);
  EXPECT_EQ(file.source.y, Doubles(3, 20));
}

TEST(ReadWeights, TakesScripFilesWithAnglesInRadians) {
  const TemporaryFolder folder;
  {
    NetcdfMaker maker(folder.path("scrip.nc"));
    const int a = maker.dimension("src_grid_size", 4),
              b = maker.dimension("dst_grid_size", 1),
              rank = maker.dimension("src_grid_rank", 2),
              s = maker.dimension("num_links", 2), w = maker.dimension("num_wgts", 1);
    const int dims = maker.variable("src_grid_dims", {rank}, NC_INT),
              x = maker.variable("src_grid_center_lon", {a}),
              y = maker.variable("src_grid_center_lat", {a}),
              mask = maker.variable("src_grid_imask", {a}, NC_INT),
              fraction = maker.variable("dst_grid_frac", {b}),
              from = maker.variable("src_address", {s}, NC_INT),
              to = maker.variable("dst_address", {s}, NC_INT),
              weight = maker.variable("remap_matrix", {s, w});
    maker.text(x, "units", "radians");
    maker.text(y, "units", "radians");
    maker.put(dims, {2, 2});
    maker.put(x, Doubles(4, std::numbers::pi / 2));
    maker.put(y, Doubles(4, -std::numbers::pi / 6));
    maker.put(mask, {1, 1, 0, 1});
    maker.put(fraction, {1});
    maker.put(from, {4, 2});
    maker.put(to, {1, 1});
    maker.put(weight, {0.25, 0.75});
  }
  const WeightsFile file = read_weights(folder.path("scrip.nc"));
  EXPECT_EQ(file.weights.apply(Doubles{0, 4, 0, 8}), Doubles{5});
  EXPECT_NEAR(file.source.x[0], 90, 1e-12);
  EXPECT_NEAR(file.source.y[0], -30, 1e-12);
  EXPECT_EQ(file.source.shape, (std::vector<std::int32_t>{2, 2}));
  EXPECT_EQ(file.source.mask, (std::vector<std::int32_t>{1, 1, 0, 1}));
}

TEST(ReadWeights, NamesTheFileAndWhatIsWrongInOneLine) {
  const TemporaryFolder folder;
  const auto complaint = [&](const Entries& entries) {
    const std::string path = put_esmf(folder, entries);
    const std::string message = message_of<ReadError>([&] { (void)read_weights(path); });
    EXPECT_TRUE(message.starts_with(path + ": ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message.substr(std::min(message.size(), path.size() + 2));
  };
  EXPECT_EQ(complaint({.source = {3, 4, 1}}),
            "variable 'col': entry 2 is not a number of 1 to 3; the file is damaged or "
            "for other grids");
  EXPECT_EQ(complaint({.target = {0, 1, 1}}),
            "variable 'row': entry 1 is not a number of 1 to 2; the file is damaged or "
            "for other grids");
  EXPECT_EQ(complaint({.target = {1, 1}}), "variable 'row' has 2 entries for 3 weights");
  EXPECT_EQ(complaint({.weight = {1, NAN, 1}}), "variable 'S': entry 2 is not finite");
}

TEST(ReadWeights, RefusesFilesWithoutWeightsOrWithSeveralALink) {
  const TemporaryFolder folder;
  write_grid(folder.path("grid.nc"), test::small_grid());
  EXPECT_NE(message_of<ReadError>([&] {
              (void)read_weights(folder.path("grid.nc"));
            }).find("no weights"),
            std::string::npos);
  {
    NetcdfMaker maker(folder.path("second.nc"));
    const int s = maker.dimension("num_links", 1), w = maker.dimension("num_wgts", 3);
    const int from = maker.variable("src_address", {s}, NC_INT),
              to = maker.variable("dst_address", {s}, NC_INT),
              weight = maker.variable("remap_matrix", {s, w});
    maker.put(from, {1});
    maker.put(to, {1});
    maker.put(weight, {1, 0, 0});
  }
  EXPECT_NE(message_of<ReadError>([&] {
              (void)read_weights(folder.path("second.nc"));
            }).find("3 weights a link"),
            std::string::npos);
  EXPECT_NE(message_of<ReadError>([&] { (void)read_weights(folder.path("no.nc")); }),
            "nothing thrown");
}

TEST(ReadWeights, RefusesSizesThatOnlyAHeaderClaims) {
  const TemporaryFolder folder;
  {
    NetcdfMaker maker(folder.path("a.nc"));
    maker.dimension("n_a", 3);
    maker.dimension("n_b", 2'000'000'000);
    const int s = maker.dimension("n_s", 1);
    const int row = maker.variable("row", {s}, NC_INT),
              col = maker.variable("col", {s}, NC_INT), weight = maker.variable("S", {s});
    maker.put(row, {1});
    maker.put(col, {1});
    maker.put(weight, {1});
  }
  EXPECT_NE(message_of<ReadError>([&] {
              (void)read_weights(folder.path("a.nc"));
            }).find("too large for this file"),
            std::string::npos);
}

// Whatever is damaged or cut off: weights with sound indices, or a ReadError.
TEST(ReadWeights, SurvivesDamagedFiles) {
  const TemporaryFolder folder;
  write_weights(folder.path("a.nc"), small_weights());
  const std::string sound = content_of(folder.path("a.nc"));
  int num_refused = 0;
  for (std::size_t i = 0; i < sound.size(); i += 7) {
    for (const char damage : {'\x00', '\x7f', '\xff'}) {
      std::string bytes = sound;
      bytes[i] = damage;
      if (damage == '\xff') bytes.resize(i);
      const std::string path = folder.put("b.nc", bytes);
      try {
        const WeightsFile file = read_weights(path);
        EXPECT_LE(file.weights.matrix().nonZeros(), 100);
        (void)file.weights.apply(
            Doubles(static_cast<std::size_t>(file.weights.matrix().cols()), 1));
      } catch (const ReadError& error) {
        ++num_refused;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
  EXPECT_GT(num_refused, 50);
}

}  // namespace
}  // namespace delone::io
