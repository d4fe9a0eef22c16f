#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "io/netcdf_image.hpp"
#include "io/table.hpp"
#include "io/weights_file.hpp"
#include "io/weights_layout.hpp"

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
  if (side.corner_x.size() != side.corner_y.size() ||
      (!side.corner_x.empty() &&
       (side.x.empty() || side.corner_x.size() % side.x.size() != 0)))
    throw Error("the " + name + " has not equally many corners a point, in x and y");
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
  SideWriter(NetcdfImage& image, const WeightsSide& side, Eigen::Index size,
             const WeightsSideNames& names)
      : image_(image), side_(side), size_(static_cast<std::size_t>(size)) {
    const int points = image.add_dimension(names.size, size);
    const auto rank = std::ssize(shape_of(side, size));
    const int axes = image.add_dimension(names.rank, rank);
    shape_ = image.add_variable(names.shape, {axes}, NC_INT);
    if (!side.x.empty()) add_coordinates(points, names);
    mask_ = add_variable(names.mask, points, NC_INT);
    fraction_ = add_variable(names.fraction, points);
    area_ = add_variable(names.area, points);
  }

  void put(const std::vector<double>& fraction) {
    image_.put(shape_, shape_of(side_, static_cast<Eigen::Index>(size_)));
    if (!side_.x.empty()) {
      image_.put(x_, side_.x);
      image_.put(y_, side_.y);
      image_.put(corner_x_, side_.corner_x.empty() ? side_.x : side_.corner_x);
      image_.put(corner_y_, side_.corner_y.empty() ? side_.y : side_.corner_y);
    }
    image_.put(mask_,
               side_.mask.empty() ? std::vector<std::int32_t>(size_, 1) : side_.mask);
    image_.put(fraction_, fraction);
    image_.put(area_, std::vector<double>(size_, 0));
  }

 private:
  int add_variable(const char* name, int points, nc_type type = NC_DOUBLE) {
    const int variable = image_.add_variable(name, {points}, type);
    image_.add_text(variable, "units", "unitless");
    return variable;
  }

  // NCO does without neither corners nor areas.
  void add_coordinates(int points, const WeightsSideNames& names) {
    const bool is_globe = side_.space == Mesh::Space::globe;
    const std::size_t num_corners =
        side_.corner_x.size() / std::max<std::size_t>(size_, 1);
    const int corners = image_.add_dimension(
        names.num_corners,
        side_.corner_x.empty() ? 1 : static_cast<std::int64_t>(num_corners));
    x_ = image_.add_variable(names.x, {points});
    y_ = image_.add_variable(names.y, {points});
    corner_x_ = image_.add_variable(names.corner_x, {points, corners});
    corner_y_ = image_.add_variable(names.corner_y, {points, corners});
    for (const int variable : {x_, y_, corner_x_, corner_y_})
      image_.add_text(variable, "units", is_globe ? "degrees" : side_.units);
  }

  NetcdfImage& image_;
  const WeightsSide& side_;
  std::size_t size_;
  int shape_ = 0, x_ = 0, y_ = 0, corner_x_ = 0, corner_y_ = 0, mask_ = 0, fraction_ = 0,
      area_ = 0;
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

void check(const std::string& path, const WeightsFile& file, WeightsLayout layout) {
  const Operator::Matrix& m = file.weights.matrix();
  check(file.source, m.cols(), "source");
  check(file.target, m.rows(), "target");
  check_size(file.fraction.size(), m.rows(), "target fractions");
  constexpr Eigen::Index most = (Eigen::Index{1} << 29) - 1;  // 4 GiB a variable
  if (m.nonZeros() > most)
    throw WriteError(path + ": more than 2^29 - 1 weights; split the targets");
  if (layout == WeightsLayout::esmf) return;
  for (const WeightsSide* side : {&file.source, &file.target}) {
    if (side->space != Mesh::Space::globe || side->x.empty())
      throw Error(
          path +
          ": the layout of SCRIP is for longitude and latitude; take that of ESMF");
  }
}

/// What CDO calls a side.
const char* grid_name(const WeightsSide& side) {
  return side.shape.size() == 2 ? "lonlat" : "unstructured";
}

void add_attributes(NetcdfImage& image, const WeightsFile& file, WeightsLayout layout) {
  const bool is_scrip = layout == WeightsLayout::scrip;
  // CDO reads no file without.
  const std::string unnamed = is_scrip ? "weights" : "";
  image.add_text(NC_GLOBAL, "title", file.title.empty() ? unnamed : file.title);
  image.add_text(NC_GLOBAL, "normalization", file.normalization);
  if (!is_scrip) {
    image.add_text(NC_GLOBAL, "map_method", file.map_method);
    image.add_text(NC_GLOBAL, "conventions", "NCAR-CSM");
    return;
  }
  image.add_text(NC_GLOBAL, "map_method", "Distance weighted avg of nearest neighbors");
  image.add_text(NC_GLOBAL, "method", file.map_method);
  image.add_text(NC_GLOBAL, "conventions", "SCRIP");
  image.add_text(NC_GLOBAL, "source_grid", grid_name(file.source));
  image.add_text(NC_GLOBAL, "dest_grid", grid_name(file.target));
}

double step_of(const interp::Axis& axis) {
  return axis.parts > 0 ? axis.length / static_cast<double>(axis.parts) : axis.spacing;
}

/// Half a step from the centre, south-west first, counter-clockwise.
void add_corners(WeightsSide& side, const interp::Grid& grid, double x, double y) {
  const double half_x = step_of(grid.x) / 2, half_y = step_of(grid.y) / 2;
  const bool is_globe = side.space == Mesh::Space::globe;
  const double most = is_globe ? 90 : std::numeric_limits<double>::infinity();
  const double south = std::max(y - half_y, -most), north = std::min(y + half_y, most);
  side.corner_x.insert(side.corner_x.end(),
                       {x - half_x, x + half_x, x + half_x, x - half_x});
  side.corner_y.insert(side.corner_y.end(), {south, south, north, north});
}

}  // namespace

WeightsSide weights_side(const interp::Grid& grid, Mesh::Space space) {
  interp::check(grid);
  WeightsSide side{.space = space};
  for (std::int64_t j = 0; j < grid.y.size; ++j) {
    for (std::int64_t i = 0; i < grid.x.size; ++i) {
      side.x.push_back(grid.x.coordinate(i));
      side.y.push_back(grid.y.coordinate(j));
      add_corners(side, grid, side.x.back(), side.y.back());
    }
  }
  side.shape = {static_cast<std::int32_t>(grid.x.size),
                static_cast<std::int32_t>(grid.y.size)};
  return side;
}

void write_weights(const std::string& path, const WeightsFile& file,
                   WeightsLayout layout) {
  check(path, file, layout);
  const Operator::Matrix& m = file.weights.matrix();
  const bool is_scrip = layout == WeightsLayout::scrip;
  const WeightsNames& names = is_scrip ? scrip_names : esmf_names;
  OutputFile output(path);
  NetcdfImage image(path);
  add_attributes(image, file, layout);
  SideWriter source(image, file.source, m.cols(), names.source);
  SideWriter target(image, file.target, m.rows(), names.target);
  const int links = image.add_dimension(names.num_links, m.nonZeros());
  std::vector<int> dimensions{links};
  if (is_scrip) dimensions.push_back(image.add_dimension("num_wgts", 1));
  const int column = image.add_variable(names.source_index, {links}, NC_INT);
  const int row = image.add_variable(names.target_index, {links}, NC_INT);
  const int weight = image.add_variable(names.weight, dimensions);
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
