#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <string>

#include "stripack/defect.hpp"
#include "stripack/triangulation.hpp"
#include "support/corpus.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace delone::support {
void PrintTo(const CorpusCase& c, std::ostream* out) {
  *out << c.name << ": " << c.title;
}
}  // namespace delone::support

namespace delone::stripack {
namespace {

class SphereCorpus : public testing::TestWithParam<support::CorpusCase> {};

TEST_P(SphereCorpus, IsTriangulatedExactly) {
  const auto& points = GetParam().sphere;
  const Triangulation t(points);
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
  EXPECT_EQ(find_defect(points, t.triangles()).value_or("none"), "none");
  EXPECT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_TRUE(Triangulation(support::shuffled(points, seed)).adjacency() ==
                t.adjacency());
  }
}

TEST(SphereCorpusFolder, IsNotEmpty) {
  EXPECT_FALSE(support::sphere_corpus(DELONE_CORPUS_DIR).empty());
}

std::string test_name(const testing::TestParamInfo<support::CorpusCase>& c) {
  std::string name = c.param.name;
  for (char& letter : name)
    letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpus, SphereCorpus,
                         testing::ValuesIn(support::sphere_corpus(DELONE_CORPUS_DIR)),
                         test_name);

}  // namespace
}  // namespace delone::stripack
