// OFF and Qhull's output option `o`, which has a dimension where OFF has its keyword.
// Source of OFF: M. Phillips and others, Geomview manual, "OFF Files", "Binary Format".

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "delaunay/error.hpp"
#include "io/byte_order.hpp"
#include "io/file_bytes.hpp"
#include "io/mesh_points.hpp"
#include "io/table.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

/// What stands in front of the counts.
struct Header {
  std::int64_t dimension = 3;  ///< coordinates of a node
  bool is_binary = false;
  /// Bytes of what follows the coordinates of a node in a binary file.
  std::size_t extra_bytes = 0;
};

/// The header for the keyword `[ST][C][N]OFF`: each letter tells of floats at every node,
/// of a texture (2), a colour (4) or a normal (3). Nothing for any other word.
std::optional<Header> header_of(std::string_view keyword) {
  Header header;
  const auto take = [&](std::string_view prefix, std::size_t num_floats) {
    if (!keyword.starts_with(prefix)) return;
    keyword.remove_prefix(prefix.size());
    header.extra_bytes += num_floats * sizeof(float);
  };
  take("ST", 2);
  take("C", 4);
  take("N", 3);
  if (keyword != "OFF") return std::nullopt;
  return header;
}

Header read_header(TextCursor& cursor) {
  const std::string_view word = cursor.need_word("the keyword OFF");
  if (auto header = header_of(word)) {
    const TextCursor behind_keyword = cursor;
    header->is_binary = cursor.word_in_line() == "BINARY";
    if (!header->is_binary) cursor = behind_keyword;
    return *header;
  }
  if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
    cursor.fail(std::string(word) + " is not read; write OFF, three coordinates a node");
  const auto dimension = to_integer(word);
  if (dimension != 2 && dimension != 3)
    cursor.fail("this is no OFF file: it begins neither with OFF nor with a dimension");
  return {.dimension = *dimension};
}

/// What follows the line of the keyword in a binary file: integers and floats of four
/// bytes, big-endian, in the order of the text; behind the corners of a cell stand the
/// number of its colour's components and these, always floats.
class BinaryReader {
 public:
  BinaryReader(std::string name, std::string_view bytes, Header header)
      : name_(std::move(name)), bytes_(bytes), left_(bytes), header_(header) {}

  Mesh read() {
    const std::int64_t num_nodes = count("the number of nodes", node_bytes());
    const std::int64_t num_cells = count("the number of cells", 8);
    static_cast<void>(integer("the number of edges"));
    require_room("the number of nodes", num_nodes, node_bytes());
    std::vector<SpacePoint> points;
    points.reserve(static_cast<std::size_t>(num_nodes));
    for (std::int64_t i = 0; i < num_nodes; ++i) points.push_back(read_point());
    Mesh mesh;
    require_room("the number of cells", num_cells, 8);
    for (std::int64_t i = 0; i < num_cells; ++i) read_cell(mesh, num_nodes);
    if (!left_.empty())
      fail("there is more than the " + std::to_string(num_nodes) + " nodes and " +
           std::to_string(num_cells) + " cells of the header");
    take_points(mesh, points);
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw ReadError(name_ + ": binary OFF, byte " + std::to_string(last_) +
                    " behind its first line: " + why);
  }

  [[nodiscard]] std::size_t node_bytes() const {
    return 3 * sizeof(float) + header_.extra_bytes;
  }

  void require_room(std::string_view what, std::int64_t number,
                    std::size_t least_bytes) const {
    if (static_cast<std::uint64_t>(number) > left_.size() / least_bytes)
      fail("the file is too short: " + std::string(what) + " is " +
           std::to_string(number) + ", and only " + std::to_string(left_.size()) +
           " bytes follow");
  }

  template <class T>
  T number(std::string_view what) {
    last_ = bytes_.size() - left_.size();
    if (left_.size() < sizeof(T))
      fail("the file ends where " + std::string(what) + " is due");
    const T value = number_at<T>(left_.data(), std::endian::big);
    left_.remove_prefix(sizeof(T));
    return value;
  }

  std::int32_t integer(std::string_view what) { return number<std::int32_t>(what); }

  /// A number of things of at least `least_bytes` each.
  std::int32_t count(std::string_view what, std::size_t least_bytes) {
    const std::int32_t value = integer(what);
    if (value < 0) fail(std::string(what) + " cannot be " + std::to_string(value));
    require_room(what, value, least_bytes);
    return value;
  }

  SpacePoint read_point() {
    SpacePoint point{};
    for (double& coordinate : point) {
      coordinate = static_cast<double>(number<float>("a coordinate"));
      if (!std::isfinite(coordinate)) fail("a coordinate is not finite");
    }
    left_.remove_prefix(header_.extra_bytes);
    return point;
  }

  void read_cell(Mesh& mesh, std::int64_t num_nodes) {
    const std::int32_t num_corners = count("the number of corners", sizeof(std::int32_t));
    for (std::int32_t k = 0; k < num_corners; ++k) {
      const std::int32_t corner = integer("a corner");
      if (corner < 0 || corner >= num_nodes)
        fail("a corner is " + std::to_string(corner) + ", outside 0.." +
             std::to_string(num_nodes - 1));
      mesh.corners.push_back(corner);
    }
    mesh.offsets.push_back(std::ssize(mesh.corners));
    const std::int32_t num_parts =
        count("the number of parts of a colour", sizeof(float));
    if (num_parts > 4)
      fail("a colour has at most 4 parts, not " + std::to_string(num_parts));
    left_.remove_prefix(static_cast<std::size_t>(num_parts) * sizeof(float));
  }

  std::string name_;
  std::string_view bytes_, left_;
  std::size_t last_ = 0;  // where the number read last begins
  Header header_;
};

/// Qhull lifts the sites of a Delaunay triangulation to this paraboloid.
double lift(double x, double y) { return x * x + y * y; }

SpacePoint read_point(TextCursor& cursor, std::int64_t dimension) {
  SpacePoint point{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    point[k] = cursor.real("a coordinate");
  cursor.skip_line();  // colours, normals
  return point;
}

void read_cell(TextCursor& cursor, Mesh& mesh, std::int64_t num_nodes) {
  const std::int64_t num_corners = cursor.count("the number of corners", 2);
  for (std::int64_t k = 0; k < num_corners; ++k)
    mesh.corners.push_back(cursor.index("a corner", num_nodes));
  mesh.offsets.push_back(std::ssize(mesh.corners));
  cursor.skip_line();
}

Mesh read_text(TextCursor& cursor, std::int64_t dimension) {
  const std::int64_t num_nodes = cursor.count("the number of nodes", 2 * dimension);
  const std::int64_t num_cells = cursor.count("the number of cells", 2);
  cursor.skip_line();  // the number of edges, which is often 0
  std::vector<SpacePoint> points;
  points.reserve(static_cast<std::size_t>(num_nodes));
  for (std::int64_t i = 0; i < num_nodes; ++i)
    points.push_back(read_point(cursor, dimension));
  Mesh mesh;
  for (std::int64_t i = 0; i < num_cells; ++i) read_cell(cursor, mesh, num_nodes);
  if (!cursor.is_at_end())
    cursor.fail("there is more than the " + std::to_string(num_nodes) + " nodes and " +
                std::to_string(num_cells) + " cells of the header");
  const bool is_lifted = std::ranges::all_of(
      points, [](const SpacePoint& p) { return p[2] == lift(p[0], p[1]); });
  // Sites on a circle of radius 0.786 are lifted to unit vectors, which they are not.
  if (is_lifted)
    for (SpacePoint& p : points) p[2] = 0;
  take_points(mesh, points);
  return mesh;
}

void write_points_and_cells(const std::string& path, std::string_view first_line,
                            const Mesh& mesh, const std::vector<SpacePoint>& points) {
  TextWriter text(path);
  text << first_line << '\n'
       << points.size() << ' ' << mesh.num_cells() << ' ' << edges_of(mesh).size()
       << '\n';
  for (const auto& [x, y, z] : points) text << x << ' ' << y << ' ' << z << '\n';
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    text << mesh.cell(i).size();
    for (const std::int32_t corner : mesh.cell(i)) text << ' ' << corner;
    text << '\n';
  }
  text.commit();
}

}  // namespace

Mesh read_off(const std::string& path) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  const Header header = read_header(cursor);
  if (header.is_binary) {
    cursor.skip_line();
    return BinaryReader(path == "-" ? "standard input" : path, cursor.rest(), header)
        .read();
  }
  return read_text(cursor, header.dimension);
}

void write_off(const std::string& path, const Mesh& mesh) {
  write_points_and_cells(path, "OFF", mesh, space_points(mesh));
}

void write_qhull_o(const std::string& path, const Mesh& mesh) {
  std::vector<SpacePoint> points = space_points(mesh);
  if (mesh.space == Mesh::Space::plane)
    for (SpacePoint& p : points) p[2] = lift(p[0], p[1]);
  if (!std::ranges::all_of(points,
                           [](const SpacePoint& p) { return std::isfinite(p[2]); }))
    throw Error(
        "Qhull's o holds x*x + y*y, which is beyond double precision here; write "
        ".off");
  write_points_and_cells(path, "3", mesh, points);
}

}  // namespace delone::io
