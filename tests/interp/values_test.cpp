#include "interp/values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "delaunay/error.hpp"
#include "support/random.hpp"

namespace delone::interp {
namespace {

using delaunay::Site;

// Site 0 has rows 0, 2, 3 and 5; site 1 has row 1; site 2 has row 4.
const std::vector<Site> sites{0, 1, 0, 0, 2, 0};
const std::vector<double> values{4, 7, 1, 2, 8, 9};

double merged(Duplicates policy) { return values_at_sites(sites, 3, values, policy)[0]; }

TEST(ValuesAtSites, AppliesThePolicyToRepeatedRows) {
  EXPECT_EQ(merged(Duplicates::mean), 4);
  EXPECT_EQ(merged(Duplicates::first), 4);
  EXPECT_EQ(merged(Duplicates::last), 9);
  EXPECT_EQ(merged(Duplicates::median), 3);
  EXPECT_EQ(merged(Duplicates::min), 1);
  EXPECT_EQ(merged(Duplicates::max), 9);
}

TEST(ValuesAtSites, KeepsSingleRowsWhateverThePolicy) {
  for (const Duplicates policy :
       {Duplicates::mean, Duplicates::median, Duplicates::last, Duplicates::max}) {
    const std::vector<double> merged = values_at_sites(sites, 3, values, policy);
    EXPECT_EQ(merged[1], 7);
    EXPECT_EQ(merged[2], 8);
  }
}

TEST(ValuesAtSites, MedianOfAnOddNumberIsTheMiddleValue) {
  EXPECT_EQ(values_at_sites(std::vector<Site>{0, 0, 0}, 1, std::vector<double>{5, 1, 2},
                            Duplicates::median)[0],
            2);
}

TEST(ValuesAtSites, MeanOfEqualValuesIsThatValue) {
  const std::vector<double> equal(3, 0.1);
  EXPECT_EQ(values_at_sites(std::vector<Site>{0, 0, 0}, 1, equal)[0], 0.1);
}

TEST(ValuesAtSites, DoesNotDependOnTheOrderOfRows) {
  support::SplitMix64 random(1);
  std::vector<double> many(1001);
  for (double& v : many)
    v = std::ldexp(random.between(-1, 1), static_cast<int>(random.below(40)));
  const std::vector<Site> one_site(many.size(), 0);
  for (const Duplicates policy :
       {Duplicates::mean, Duplicates::median, Duplicates::min, Duplicates::max}) {
    const double value = values_at_sites(one_site, 1, many, policy)[0];
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      EXPECT_EQ(values_at_sites(one_site, 1, support::shuffled(many, seed), policy)[0],
                value);
    }
  }
}

TEST(ValuesAtSites, RefusesAnotherNumberOfValuesThanPoints) {
  EXPECT_THROW((void)values_at_sites(sites, 3, std::vector<double>(5)), Error);
  EXPECT_THROW((void)values_at_sites(sites, 3, std::vector<double>(7)), Error);
}

TEST(ValuesAtSites, NamesTheRowOfAValueThatIsNotANumber) {
  for (const double bad :
       {std::nan(""), std::numeric_limits<double>::infinity(), -1e200}) {
    std::vector<double> with_bad = values;
    with_bad[4] = bad;
    try {
      (void)values_at_sites(sites, 3, with_bad);
      FAIL() << bad << " was taken";
    } catch (const Error& e) {
      ASSERT_EQ(e.rows().size(), 1u);
      EXPECT_EQ(e.rows()[0], 4);
      EXPECT_NE(std::string(e.what()).find("row 4"), std::string::npos);
    }
  }
}

TEST(ValuesAtSites, ErrorPolicyNamesTwoRowsThatDiffer) {
  try {
    (void)values_at_sites(sites, 3, values, Duplicates::error);
    FAIL();
  } catch (const Error& e) {
    ASSERT_EQ(e.rows().size(), 2u);
    EXPECT_EQ(e.rows()[0], 0);
    EXPECT_EQ(e.rows()[1], 2);
  }
}

TEST(ValuesAtSites, ErrorPolicyAcceptsRepeatsThatAgree) {
  EXPECT_EQ(values_at_sites(std::vector<Site>{0, 1, 0}, 2, std::vector<double>{3, 5, 3},
                            Duplicates::error),
            (std::vector<double>{3, 5}));
}

TEST(RowsOfSites, ListsTheRowsOfEverySiteInOrder) {
  const RowsOfSites rows = rows_of_sites(sites, 3);
  EXPECT_EQ(std::vector<delaunay::Node>(rows.of(0).begin(), rows.of(0).end()),
            (std::vector<delaunay::Node>{0, 2, 3, 5}));
  EXPECT_EQ(rows.of(1)[0], 1);
  EXPECT_EQ(rows.of(2).size(), 1u);
}

}  // namespace
}  // namespace delone::interp
