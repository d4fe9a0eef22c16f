// Time of changing a large triangulation: random insertions and removals, one by one.
//
//   taskset -c 0 edit_bench [--points N] [--edits N] [--only SET]
//
// Starts with N points (1,000,000) and makes as many edits, insertions and removals in
// turn, at random places and without hints; then times giving back the triangulation, and
// compares it with a fresh one. Processor time: what a busy machine leaves comparable.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "stripack/editor.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"
#include "tripack/editor.hpp"

namespace delone::bench {
namespace {

using delaunay::Node;

struct Settings {
  std::size_t num_points = 1000000;
  std::size_t num_edits = 1000000;
  std::string only;
};

double microseconds_each(double seconds, std::size_t count) {
  return 1e6 * seconds / static_cast<double>(count);
}

// What goes is chosen beforehand, so that choosing is not timed: the k-th removal takes
// the row that insertion k - 1 was given, or one of the first rows, each at most once.
std::vector<Node> removals(std::size_t num_points, std::size_t count) {
  std::vector<Node> rows(num_points);
  for (std::size_t i = 0; i < num_points; ++i) rows[i] = static_cast<Node>(i);
  rows = support::shuffled(std::move(rows), 3);
  rows.resize(std::min(count, num_points));
  return rows;
}

// First half of `points` are there, the second half come in.
template <class Editor, class Triangulation, class Points>
void run(const std::string& name, const Points& points, const Settings& s) {
  if (!s.only.empty() && s.only != name) return;
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(s.num_points);
  const Triangulation first(Points(points.begin(), middle));
  Editor editor;
  const double start = seconds([&] { editor = Editor(first); }).cpu;
  const std::vector<Node> going = removals(s.num_points, s.num_edits / 2);
  const auto insert_all = [&] {
    for (std::size_t i = 0; i < going.size(); ++i)
      editor.insert(middle[static_cast<std::ptrdiff_t>(i)]);
  };
  const auto remove_all = [&] {
    for (const Node row : going) editor.remove(row);
  };
  const auto in_turn = [&] {
    for (std::size_t i = 0; i < going.size(); ++i) {
      editor.insert(middle[static_cast<std::ptrdiff_t>(i)]);
      editor.remove(going[i]);
    }
  };
  const double mixed = seconds(in_turn).cpu;
  Editor other(first);
  editor = std::move(other);
  const double inserting = seconds(insert_all).cpu;
  const double removing = seconds(remove_all).cpu;
  Triangulation changed;
  const double giving = seconds([&] { changed = editor.triangulation(); }).cpu;
  const bool is_same = changed.adjacency() == Triangulation(editor.points()).adjacency();
  std::printf("%-18s %9zu %9.2f %9.2f %9.2f %10.0f %10.0f  %s\n", name.c_str(),
              s.num_points, microseconds_each(mixed, 2 * going.size()),
              microseconds_each(inserting, going.size()),
              microseconds_each(removing, going.size()), 1e3 * start, 1e3 * giving,
              is_same ? "yes" : "NO");
  std::fflush(stdout);
}

void run_all(const Settings& s) {
  std::printf("%-18s %9s %9s %9s %9s %10s %10s  %s\n", "set", "points", "us/edit",
              "us/insert", "us/remove", "begin ms", "give ms", "canonical");
  const std::size_t n = 2 * s.num_points;
  run<tripack::Editor, tripack::Triangulation>("uniform", support::uniform_points(n, 1),
                                               s);
  run<tripack::Editor, tripack::Triangulation>(
      "clusters", support::shuffled(support::clustered_points(n, 1), 2), s);
  run<tripack::Editor, tripack::Triangulation>(
      "lattice", support::shuffled(support::lattice_points(2 * n), 2), s);
  run<stripack::Editor, stripack::Triangulation>("sphere",
                                                 support::uniform_directions(n, 1), s);
  run<stripack::Editor, stripack::Triangulation>(
      "tracks", support::shuffled(support::track_directions(n), 2), s);
}

}  // namespace
}  // namespace delone::bench

int main(int argc, char** argv) {
  delone::bench::Settings settings;
  for (int i = 1; i + 1 < argc; i += 2) {
    const auto count = static_cast<std::size_t>(std::atoll(argv[i + 1]));
    if (std::strcmp(argv[i], "--points") == 0) settings.num_points = count;
    if (std::strcmp(argv[i], "--edits") == 0) settings.num_edits = count;
    if (std::strcmp(argv[i], "--only") == 0) settings.only = argv[i + 1];
  }
  delone::bench::run_all(settings);
}
