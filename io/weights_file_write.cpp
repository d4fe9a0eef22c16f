#include <limits>
#include <string>
#include <utility>

#include "io/netcdf_image.hpp"
#include "io/table.hpp"
#include "io/weights_file.hpp"

namespace delone::io {
namespace {

using interp::Operator;

void check_size(std::size_t found, Eigen::Index wanted, const std::string& what) {
  if (found == 0 || static_cast<Eigen::Index>(found) == wanted) return;
  throw Error("the operator has " + std::to_string(wanted) + " points where there are " +
              std::to_string(found) + " of the " + what + "; give one a point");
}

void check(const WeightsSide& side, Eigen::Index size, const std::string& name) {
  check_size(side.x.size(), size, name + " x");
  check_size(side.y.size(), size, name + " y");
  check_size(side.mask.size(), size, name + " mask");
  if (side.x.size() != side.y.size())
    throw Error("the " + name + " has x without y or y without x; give both or none");
  if (side.shape.empty()) return;
  std::int64_t product = 1;
  for (const std::int32_t n : side.shape) {
    if (n < 0 || __builtin_mul_overflow(product, std::int64_t{n}, &product))
      throw Error("the shape of the " + name + " is negative or too large");
  }
  if (product != size) {
    throw Error("the shape of the " + name + " has " + std::to_string(product) +
                " points, the operator " + std::to_string(size));
  }
}

std::vector<std::int32_t> shape_of(const WeightsSide& side, Eigen::Index size) {
  return side.shape.empty() ? std::vector<std::int32_t>{static_cast<std::int32_t>(size)}
                            : side.shape;
}

/// One side's variables, defined first and filled afterwards.
class SideWriter {
 public:
  SideWriter(NetcdfImage& image, const WeightsSide& side, Eigen::Index size, char letter)
      : image_(image), side_(side), size_(static_cast<std::size_t>(size)) {
    const std::string end = std::string("_") + letter;
    const bool is_source = letter == 'a';
    const int points = image.add_dimension(("n" + end).c_str(), size);
    const auto rank = std::ssize(shape_of(side, size));
    const int axes =
        image.add_dimension(is_source ? "src_grid_rank" : "dst_grid_rank", rank);
    shape_ =
        image.add_variable(is_source ? "src_grid_dims" : "dst_grid_dims", {axes}, NC_INT);
    if (!side.x.empty()) add_coordinates(points, end);
    mask_ = image.add_variable("mask" + end, {points}, NC_INT);
    image.add_text(mask_, "units", "unitless");
    fraction_ = image.add_variable("frac" + end, {points});
    image.add_text(fraction_, "units", "unitless");
  }

  void put(const std::vector<double>& fraction) {
    image_.put(shape_, shape_of(side_, static_cast<Eigen::Index>(size_)));
    if (!side_.x.empty()) {
      image_.put(x_, side_.x);
      image_.put(y_, side_.y);
    }
    image_.put(mask_,
               side_.mask.empty() ? std::vector<std::int32_t>(size_, 1) : side_.mask);
    image_.put(fraction_, fraction);
  }

 private:
  void add_coordinates(int points, const std::string& end) {
    const bool is_globe = side_.space == Mesh::Space::globe;
    x_ = image_.add_variable("xc" + end, {points});
    y_ = image_.add_variable("yc" + end, {points});
    for (const int variable : {x_, y_})
      image_.add_text(variable, "units", is_globe ? "degrees" : side_.units);
  }

  NetcdfImage& image_;
  const WeightsSide& side_;
  std::size_t size_;
  int shape_ = 0, x_ = 0, y_ = 0, mask_ = 0, fraction_ = 0;
};

std::vector<double> used_targets(const Operator::Matrix& m) {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    result.push_back(m.outerIndexPtr()[i + 1] > m.outerIndexPtr()[i] ? 1 : 0);
  return result;
}

std::vector<double> used_sources(const Operator::Matrix& m) {
  std::vector<double> result(static_cast<std::size_t>(m.cols()));
  for (Eigen::Index k = 0; k < m.nonZeros(); ++k)
    result[static_cast<std::size_t>(m.innerIndexPtr()[k])] = 1;
  return result;
}

std::vector<std::int32_t> columns_from_one(const Operator::Matrix& m) {
  std::vector<std::int32_t> result(m.innerIndexPtr(), m.innerIndexPtr() + m.nonZeros());
  for (std::int32_t& column : result) ++column;
  return result;
}

std::vector<std::int32_t> rows_from_one(const Operator::Matrix& m) {
  std::vector<std::int32_t> result;
  result.reserve(static_cast<std::size_t>(m.nonZeros()));
  for (int i = 0; i < m.rows(); ++i)
    result.insert(
        result.end(),
        static_cast<std::size_t>(m.outerIndexPtr()[i + 1] - m.outerIndexPtr()[i]), i + 1);
  return result;
}

void check(const std::string& path, const WeightsFile& file) {
  const Operator::Matrix& m = file.weights.matrix();
  check(file.source, m.cols(), "source");
  check(file.target, m.rows(), "target");
  check_size(file.fraction.size(), m.rows(), "target fractions");
  constexpr Eigen::Index most = (Eigen::Index{1} << 29) - 1;  // 4 GiB a variable
  if (m.nonZeros() > most)
    throw WriteError(path + ": more than 2^29 - 1 weights; split the targets");
}

}  // namespace

WeightsSide weights_side(const interp::Grid& grid, Mesh::Space space) {
  interp::check(grid);
  WeightsSide side{.space = space};
  for (std::int64_t j = 0; j < grid.y.size; ++j) {
    for (std::int64_t i = 0; i < grid.x.size; ++i) {
      side.x.push_back(grid.x.coordinate(i));
      side.y.push_back(grid.y.coordinate(j));
    }
  }
  side.shape = {static_cast<std::int32_t>(grid.x.size),
                static_cast<std::int32_t>(grid.y.size)};
  return side;
}

void write_weights(const std::string& path, const WeightsFile& file) {
  check(path, file);
  const Operator::Matrix& m = file.weights.matrix();
  OutputFile output(path);
  NetcdfImage image(path);
  image.add_text(NC_GLOBAL, "title", file.title);
  image.add_text(NC_GLOBAL, "normalization", file.normalization);
  image.add_text(NC_GLOBAL, "map_method", file.map_method);
  image.add_text(NC_GLOBAL, "conventions", "NCAR-CSM");
  SideWriter source(image, file.source, m.cols(), 'a');
  SideWriter target(image, file.target, m.rows(), 'b');
  const int links = image.add_dimension("n_s", m.nonZeros());
  const int column = image.add_variable("col", {links}, NC_INT);
  const int row = image.add_variable("row", {links}, NC_INT);
  const int weight = image.add_variable("S", {links});
  image.end_definitions();
  source.put(used_sources(m));
  target.put(file.fraction.empty() ? used_targets(m) : file.fraction);
  image.put(column, columns_from_one(m));
  image.put(row, rows_from_one(m));
  image.put(weight, std::vector<double>(m.valuePtr(), m.valuePtr() + m.nonZeros()));
  image.write_to(output);
  output.commit();
}

}  // namespace delone::io
