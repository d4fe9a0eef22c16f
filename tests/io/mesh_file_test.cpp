// OFF, PLY, VTU, GeoJSON and UGRID.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "io/lonlat_rings.hpp"
#include "io/mesh.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::content_of;
using test::message_of;
using test::TemporaryFolder;

const std::vector<Triangle> square_triangles = {{0, 1, 2}, {0, 2, 3}};

Mesh square() {
  return triangle_mesh(Mesh::Space::plane, std::vector{0.0, 1.0, 1.0, 0.1},
                       std::vector{0.0, 0.0, 1.0, 1.0}, square_triangles);
}

/// Four nodes around the date line and the north pole.
Mesh cap() {
  return triangle_mesh(Mesh::Space::globe, std::vector{170.0, -170.0, 0.0, 10.0},
                       std::vector{10.0, 20.0, 80.0, 90.0},
                       std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}});
}

Mesh read(const std::string& name, std::string_view content) {
  const TemporaryFolder folder;
  return read_mesh(folder.put(name, content));
}

std::string complaint(const std::string& name, std::string_view content) {
  const std::string message = message_of<ReadError>([&] { return read(name, content); });
  const std::size_t at = message.find(name);
  return at == std::string::npos ? message : message.substr(at);
}

void expect_same(const Mesh& a, const Mesh& b, double tolerance_deg = 0) {
  EXPECT_EQ(a.space, b.space);
  EXPECT_EQ(a.offsets, b.offsets);
  EXPECT_EQ(a.corners, b.corners);
  ASSERT_EQ(a.num_nodes(), b.num_nodes());
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    // At a pole every longitude is the same place.
    if (std::abs(b.y[i]) < 90) {
      EXPECT_NEAR(a.x[i], b.x[i], tolerance_deg);
    }
    EXPECT_NEAR(a.y[i], b.y[i], tolerance_deg);
  }
}

class MeshFormat : public testing::TestWithParam<const char*> {};

TEST_P(MeshFormat, GivesBackAPlaneMeshBitForBit) {
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string("m.") + GetParam());
  write_mesh(path, square());
  expect_same(read_mesh(path), square());
}

TEST_P(MeshFormat, GivesBackAGlobeMesh) {
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string("m.") + GetParam());
  write_mesh(path, cap());
  expect_same(read_mesh(path), cap(), 1e-13);
}

TEST_P(MeshFormat, HoldsPolygonsAndNodesWithoutCells) {
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string("m.") + GetParam());
  Mesh mesh = square();
  mesh.offsets = {0};
  mesh.corners.clear();
  mesh.add_cell(std::vector<std::int32_t>{0, 1, 2, 3});
  mesh.add_cell(std::vector<std::int32_t>{0, 1, 2});
  mesh.x.push_back(7);
  mesh.y.push_back(8);
  write_mesh(path, mesh);
  expect_same(read_mesh(path), mesh);
}

TEST_P(MeshFormat, HoldsAMeshWithoutCells) {
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string("m.") + GetParam());
  Mesh mesh = square();
  mesh.offsets = {0};
  mesh.corners.clear();
  write_mesh(path, mesh);
  EXPECT_EQ(read_mesh(path).num_cells(), 0);
}

TEST_P(MeshFormat, WritesTheSameBytesTwice) {
  const TemporaryFolder folder;
  const std::string extension = GetParam();
  write_mesh(folder.path("a." + extension), cap());
  write_mesh(folder.path("b." + extension), cap());
  EXPECT_EQ(content_of(folder.path("a." + extension)),
            content_of(folder.path("b." + extension)));
}

TEST_P(MeshFormat, NeverTakesAFileThatIsCutShort) {
  const TemporaryFolder folder;
  const std::string extension = GetParam();
  write_mesh(folder.path("a." + extension), square());
  const std::string whole = content_of(folder.path("a." + extension));
  // The last bytes may be a final line end, padding or closing tags.
  for (std::size_t length = 0; length < whole.size() / 2; length += 7) {
    const std::string path = folder.put("cut." + extension, whole.substr(0, length));
    EXPECT_THROW(static_cast<void>(read_mesh(path)), ReadError) << length;
  }
}

INSTANTIATE_TEST_SUITE_P(All, MeshFormat,
                         testing::Values("off", "o", "ply", "vtu", "nc"));

TEST(ReadPly, CountsNoVerticesThatHaveNoPosition) {
  const std::string faces =
      "element face 1\nproperty list int int vertex_indices\nend_header\n";
  // Without properties nothing is read, and corners 0, 1, 2 would be nodes of nothing.
  EXPECT_NE(complaint("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n" + faces +
                                   "1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n")
                .find("no properties x and y"),
            std::string::npos);
  EXPECT_NE(complaint("a.ply",
                      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                      "property float y\nelement vertex 9\n" +
                          faces + "1 0\n3 0 1 2\n")
                .find("two elements"),
            std::string::npos);
}

TEST(QhullO, HasTheSitesLiftedAsQdelaunayPrintsThem) {
  const TemporaryFolder folder;
  write_mesh(folder.path("s.o"), square());
  EXPECT_EQ(content_of(folder.path("s.o")),
            "3\n4 2 5\n0 0 0\n1 0 1\n1 1 2\n0.1 1 1.01\n3 0 1 2\n3 0 2 3\n");
}

TEST(QhullO, IsReadAsQhullPrintsIt) {
  // `qdelaunay o` of five sites; the lifted coordinates may be off by a rounding.
  const Mesh mesh =
      read("q.o",
           "3\n5 4 6\n     0      0      0 \n     1      0    0.5 \n"
           "     0      1    0.5 \n     1      1      1 \n"
           "   0.3    0.6  0.225 \n3 1 4 0 \n3 4 2 0 \n3 3 4 1 \n3 4 3 2 \n");
  EXPECT_EQ(mesh.space, Mesh::Space::plane);
  EXPECT_EQ(mesh.x, (std::vector<double>{0, 1, 0, 1, 0.3}));
  EXPECT_EQ(mesh.num_cells(), 4);
}

TEST(QhullO, SitesThatAreLiftedToUnitVectorsStayInThePlane) {
  // On this circle x*x + y*y is the height of a unit vector.
  const double r = std::sqrt((std::sqrt(5.0) - 1) / 2);
  const Mesh ring =
      triangle_mesh(Mesh::Space::plane, std::vector{r, 0.0, -r}, std::vector{0.0, r, 0.0},
                    std::vector<Triangle>{{0, 1, 2}});
  const TemporaryFolder folder;
  write_mesh(folder.path("r.o"), ring);
  expect_same(read_mesh(folder.path("r.o")), ring);
}

TEST(QhullO, RefusesSitesBeyondTheRangeOfTheirSquares) {
  const TemporaryFolder folder;
  const Mesh wide =
      triangle_mesh(Mesh::Space::plane, std::vector{0.0, 1e200, 0.0},
                    std::vector{0.0, 0.0, 1.0}, std::vector<Triangle>{{0, 1, 2}});
  EXPECT_NE(message_of<Error>([&] { write_mesh(folder.path("w.o"), wide); }).find(".off"),
            std::string::npos);
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteMesh, RefusesCornersThatAreNoNodes) {
  Mesh mesh = square();
  mesh.corners[0] = 4;
  EXPECT_THROW(write_mesh("x.off", mesh), Error);
  mesh.corners[0] = -1;
  EXPECT_THROW(write_mesh("x.ply", mesh), Error);
}

TEST(WriteMesh, NamesTheFormatsThereAre) {
  EXPECT_NE(message_of<WriteError>([] { write_mesh("x.abc", square()); }).find("vtu"),
            std::string::npos);
}

TEST(TrianglesOfMesh, NamesTheCellThatIsNone) {
  Mesh mesh = square();
  mesh.add_cell(std::vector<std::int32_t>{0, 1, 2, 3});
  EXPECT_NE(message_of<Error>([&] { return triangles_of(mesh); }).find("cell 2"),
            std::string::npos);
}

TEST(ReadOff, TakesQhullsOptionO) {
  // Dimension 3: Qhull lifts the points of a Delaunay triangulation to a paraboloid.
  const Mesh mesh =
      read("a.off", "3\n4 2 5\n0 0 0.1\n1 0 1\n1 1 2\n0.1 1 1.01\n3 0 1 2\n3 0 2 3\n");
  expect_same(mesh, square());
  expect_same(read("a.off", "2\n4 2 5\n0 0\n1 0\n1 1\n0.1 1\n3 0 1 2\n3 0 2 3\n"),
              square());
}

TEST(ReadOff, TakesColoursAndCommentsAndCountsInTheFirstLine) {
  const std::string_view text =
      "OFF 4 2 0 # counts\n# nodes\n0 0 0 255 0 0\n1 0 0\n1 1 0\n0.1 1 0\n\n3 0 1 2 1 0 "
      "0\n3 0 2 3\n";
  expect_same(read("a.off", text), square());
}

TEST(ReadOff, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_EQ(complaint("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 x\n3 0 1 2\n"),
            "a.off: line 6: 'x' where a coordinate, a finite number, is due");
  EXPECT_EQ(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n"),
            "a.off: line 6: a corner is 3, outside 0..2");
  EXPECT_NE(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 0 1 2\n")
                .find("more than"),
            std::string::npos);
  EXPECT_NE(complaint("a.off", "solid").find("no OFF file"), std::string::npos);
}

TEST(ReadMesh, HoldsCountsAgainstTheFileBeforeItAllocates) {
  EXPECT_NE(complaint("a.off", "OFF\n2000000000 5 0\n0 0 0\n").find("too short"),
            std::string::npos);
  EXPECT_NE(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n1000000000 1 2\n")
                .find("too short"),
            std::string::npos);
  const std::string ply_header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1000\nproperty float "
      "x\nproperty float y\nend_header\n";
  EXPECT_NE(complaint("a.ply", ply_header + std::string(2000, 'a')).find("too short"),
            std::string::npos);
}

/// A number as the bytes of a file.
template <class T>
std::string bytes_of(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string binary_ply(std::string (*order)(std::string)) {
  std::string body;
  const std::array<std::array<float, 2>, 3> nodes{{{0, 0}, {1, 0}, {0.5, 2}}};
  for (const auto& [x, y] : nodes)
    body += order(bytes_of(x)) + order(bytes_of(y)) + std::string(1, '\7');
  body += std::string(1, '\3');
  for (const std::int32_t corner : {0, 1, 2}) body += order(bytes_of(corner));
  return body;
}

TEST(ReadPly, TakesBinaryOfBothByteOrders) {
  if (std::endian::native != std::endian::little) GTEST_SKIP() << "a big-endian machine";
  const auto header = [](const std::string& order) {
    return "ply\nformat binary_" + order +
           "_endian 1.0\ncomment made by hand\nelement vertex 3\nproperty float "
           "x\nproperty float y\nproperty uchar quality\nelement face 1\nproperty list "
           "uchar int vertex_index\nend_header\n";
  };
  const auto keep = [](std::string bytes) { return bytes; };
  const auto turn = [](std::string bytes) {
    return std::string(bytes.rbegin(), bytes.rend());
  };
  for (const Mesh& mesh : {read("l.ply", header("little") + binary_ply(keep)),
                           read("b.ply", header("big") + binary_ply(turn))}) {
    EXPECT_EQ(mesh.x, (std::vector<double>{0, 1, 0.5}));
    EXPECT_EQ(mesh.y, (std::vector<double>{0, 0, 2}));
    EXPECT_EQ(mesh.corners, (std::vector<std::int32_t>{0, 1, 2}));
  }
}

TEST(ReadPly, PassesElementsAndListsThatItDoesNotKnow) {
  const Mesh mesh = read(
      "a.ply",
      "ply\nformat ascii 1.0\nelement cloud 2\nproperty list int float weights\nelement "
      "vertex 3\nproperty double y\nproperty double x\nelement face 1\nproperty uchar "
      "red\nproperty list uchar uint vertex_indices\nend_header\n2 1.5 2.5\n0\n0 0\n0 "
      "1\n1 1\n9 3 0 1 2\n");
  EXPECT_EQ(mesh.x, (std::vector<double>{0, 1, 1}));
  EXPECT_EQ(mesh.y, (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(mesh.num_cells(), 1);
}

TEST(ReadPly, RefusesCornersThatAreNoVertices) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float "
      "y\nelement face 1\nproperty list int int vertex_indices\nend_header\n0 0\n1 1\n";
  for (const char* face : {"3 0 1 2\n", "3 0 1 -1\n", "3 0 1 0.5\n"})
    EXPECT_NE(complaint("a.ply", header + face).find("not one of the 2 vertices"),
              std::string::npos)
        << face;
}

// As VTK's own writer and meshio lay them out.
constexpr std::string_view vtu_head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
    "byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<!-- <DataArray> "
    "-->\n<UnstructuredGrid><Piece NumberOfPoints=\"3\" "
    "NumberOfCells=\"1\"><PointData><DataArray type=\"Float64\" Name=\"T\" "
    "format=\"ascii\">1 2 3</DataArray></PointData>";

TEST(ReadVtu, TakesInlineBase64) {
  // Three Float32 points (0,0,0) (1,0,0) (0,1,0); Int32 corners 0 1 2; offset 3; type 5.
  const std::string text =
      std::string(vtu_head) +
      "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
      "format=\"binary\">\nJAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
      "AAAAAA==\n</DataArray></Points><Cells><DataArray type=\"Int32\" "
      "Name=\"connectivity\" format=\"binary\">DAAAAAAAAAABAAAAAgAAAA==</"
      "DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
      "format=\"binary\">BAAAAAMAAAA=</DataArray><DataArray type=\"UInt8\" "
      "Name=\"types\" format=\"binary\">AQAAAAU=</DataArray></Cells></Piece></"
      "UnstructuredGrid></VTKFile>";
  const Mesh mesh = read("a.vtu", text);
  EXPECT_EQ(mesh.x, (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(mesh.y, (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(mesh.corners, (std::vector<std::int32_t>{0, 1, 2}));
}

TEST(ReadVtu, TakesAppendedRawData) {
  std::string data;
  const auto append = [&data](const auto& values) {
    std::string block;
    for (const auto value : values) block += bytes_of(value);
    const std::size_t offset = data.size();
    data += bytes_of(static_cast<std::uint32_t>(block.size())) + block;
    return std::to_string(offset);
  };
  const std::string points = append(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string corners = append(std::vector<std::int64_t>{2, 0, 1});
  const std::string ends = append(std::vector<std::int64_t>{3});
  const std::string types = append(std::vector<std::uint8_t>{5});
  const std::string text =
      std::string(vtu_head) +
      "<Points><DataArray type=\"Float64\" format=\"appended\" offset=\"" + points +
      "\"/></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" "
      "format=\"appended\" offset=\"" +
      corners +
      "\"/><DataArray type=\"Int64\" Name=\"offsets\" format=\"appended\" offset=\"" +
      ends +
      "\"/><DataArray type=\"UInt8\" Name=\"types\" format=\"appended\" offset=\"" +
      types +
      "\"/></Cells></Piece></UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" +
      data + "\n</AppendedData></VTKFile>";
  if (std::endian::native != std::endian::little) GTEST_SKIP() << "a big-endian machine";
  const Mesh mesh = read("a.vtu", text);
  EXPECT_EQ(mesh.x, (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(mesh.corners, (std::vector<std::int32_t>{2, 0, 1}));
}

TEST(ReadVtu, SaysWhatItDoesNotRead) {
  EXPECT_NE(complaint("a.vtu", "<VTKFile type=\"PolyData\"></VTKFile>").find("not of an"),
            std::string::npos);
  EXPECT_NE(complaint("a.vtu", "<html>").find("no VTK file"), std::string::npos);
}

TEST(WriteUgrid, IsWhatTheConventionsAskFor) {
  const TemporaryFolder folder;
  write_mesh(folder.path("m.nc"), cap());
  EXPECT_TRUE(holds_ugrid(folder.path("m.nc")));
  const std::string bytes = content_of(folder.path("m.nc"));
  for (const char* word : {"UGRID-1.0", "mesh_topology", "face_node_connectivity",
                           "start_index", "degrees_east", "topology_dimension"})
    EXPECT_NE(bytes.find(word), std::string::npos) << word;
}

TEST(WriteGeojson, WritesAPolygonATriangle) {
  const TemporaryFolder folder;
  const std::string path = folder.path("m.geojson");
  write_mesh(path,
             triangle_mesh(Mesh::Space::plane, std::vector{0.0, 1.0, 0.5},
                           std::vector{0.0, 0.0, 1.0}, std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(content_of(path),
            "{\"type\":\"FeatureCollection\",\"features\":[\n{\"type\":\"Feature\","
            "\"id\":0,\"properties\":{\"nodes\":[0,1,2]},\"geometry\":{\"type\":"
            "\"Polygon\",\"coordinates\":[[[0,0],[1,0],[0.5,1],[0,0]]]}}\n]}\n");
}

double area_of(const PlaneRing& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

TEST(CutAtDateLine, LeavesPolygonsElsewhereAsTheyAre) {
  const PlaneRing ring = {{0, 0}, {10, 0}, {5, 10}};
  EXPECT_EQ(cut_at_date_line(ring), std::vector<PlaneRing>{ring});
  // Other wraps come back to -180..180; touching the date line is not crossing it.
  EXPECT_EQ(cut_at_date_line({{350, 0}, {370, 0}, {365, 10}}),
            (std::vector<PlaneRing>{{{-10, 0}, {10, 0}, {5, 10}}}));
  EXPECT_EQ(cut_at_date_line({{170, 0}, {180, 0}, {175, 10}}).size(), 1U);
  EXPECT_EQ(cut_at_date_line({{-180, 0}, {-170, 0}, {-175, 10}}).size(), 1U);
}

TEST(CutAtDateLine, CutsWhereTheGreatCirclesMeetIt) {
  const auto rings = cut_at_date_line({{170, 0}, {-170, 0}, {180, 40}});
  ASSERT_EQ(rings.size(), 2U);
  for (const PlaneRing& ring : rings) {
    EXPECT_GT(area_of(ring), 0);
    for (const auto& [lon, lat] : ring) EXPECT_LE(std::abs(lon), 180);
  }
  EXPECT_NEAR(area_of(rings[0]), area_of(rings[1]), 1e-9);
  // The great circle from (170, 40) to (-170, 40) is at 40.4 degrees at the date line.
  const auto bulged = cut_at_date_line({{170, 0}, {-170, 0}, {-170, 40}, {170, 40}});
  double highest = 0;
  for (const auto& [lon, lat] : bulged[0]) highest = std::max(highest, lat);
  EXPECT_NEAR(
      highest,
      std::atan(std::tan(40 * M_PI / 180) / std::cos(10 * M_PI / 180)) * 180 / M_PI,
      1e-9);
}

TEST(CutAtDateLine, ReachesAlongThePoleThatAPolygonHolds) {
  const auto north = cut_at_date_line({{0, 60}, {120, 60}, {-120, 60}});
  double area = 0;
  for (const PlaneRing& ring : north) area += area_of(ring);
  // All longitudes, from the pole down to the sides; the one over the date line is cut
  // there, where its great circle is at 73.9 degrees.
  constexpr double degree = std::numbers::pi / 180;
  const double highest =
      std::atan(std::tan(60 * degree) / std::cos(60 * degree)) / degree;
  const double expected = 360 * 30 - 120 * (highest - 60) / 2;
  EXPECT_NEAR(area, expected, 1e-9);
  const auto south = cut_at_date_line({{0, -60}, {-120, -60}, {120, -60}});
  area = 0;
  for (const PlaneRing& ring : south) area += area_of(ring);
  EXPECT_NEAR(area, expected, 1e-9);
}

TEST(CutAtDateLine, GivesACornerAtThePoleTheLongitudesOfItsNeighbours) {
  EXPECT_EQ(cut_at_date_line({{0, 0}, {50, 0}, {-77, 90}}),
            (std::vector<PlaneRing>{{{0, 0}, {50, 0}, {50, 90}, {0, 90}}}));
  EXPECT_EQ(cut_at_date_line({{170, 0}, {-170, 0}, {3, 90}}).size(), 2U);
}

}  // namespace
}  // namespace delone::io
