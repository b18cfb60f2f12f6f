// Gravel, sand, fines.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/fractions.hpp"

#include <algorithm>

namespace fractions_test {

using namespace mdm;
using namespace grading_test;

namespace {

const Fraction &named(const std::vector<Fraction> &fractions, std::string_view name) {
  return *std::find_if(fractions.begin(), fractions.end(),
                       [name](const Fraction &f) { return f.name == name; });
}

std::optional<Rational> share(const std::vector<Fraction> &fractions, std::string_view name) {
  const Available<Real> &s = named(fractions, name).share;
  return s ? s->exact() : std::nullopt;
}

Rational percent(int n) {
  return ratio(n, 100);
}

/// The main bands meet without gaps, and the parts of each fill it.
void check_bands(const std::vector<Fraction> &fractions) {
  std::optional<Rational> main_end, part_end;
  for (const Fraction &f : fractions) {
    if (!f.main) {
      CHECK(f.up_to == part_end);
      part_end = f.above;
      CHECK(f.above >= *main_end);
      continue;
    }
    if (part_end)
      CHECK((*part_end == *main_end || *part_end > *main_end));
    CHECK(f.up_to == main_end);
    part_end = f.up_to;
    main_end = f.above;
  }
  CHECK(main_end == Rational(0));
}

} // namespace

TEST_CASE("the bands of a system cover all sizes") {
  const GradingCurve c = curve({{"1", "0"}, {"2", "100"}});
  check_bands(uscs_fractions(c));
  check_bands(iso_14688_fractions(c));
}

TEST_CASE("USCS fractions at their sieves are exact, a size belongs to the band that it ends") {
  const std::vector<Fraction> f = uscs_fractions(curve({{"0.01", "0"},
                                                        {"0.075", "3"},
                                                        {"0.425", "10"},
                                                        {"2", "20"},
                                                        {"4.75", "35"},
                                                        {"19", "55"},
                                                        {"75", "85"},
                                                        {"300", "96"},
                                                        {"500", "100"}}));
  CHECK(share(f, "fines") == percent(3));
  CHECK(share(f, "sand") == percent(32));
  CHECK(share(f, "fine sand") == percent(7));
  CHECK(share(f, "medium sand") == percent(10));
  CHECK(share(f, "coarse sand") == percent(15));
  CHECK(share(f, "gravel") == percent(50));
  CHECK(share(f, "fine gravel") == percent(20));
  CHECK(share(f, "coarse gravel") == percent(30));
  CHECK(share(f, "cobbles") == percent(11));
  CHECK(share(f, "boulders") == percent(4));
}

TEST_CASE("ISO 14688 fractions at their sieves are exact") {
  const std::vector<Fraction> f = iso_14688_fractions(curve({{"0.001", "0"},
                                                             {"0.002", "1"},
                                                             {"0.0063", "3"},
                                                             {"0.02", "6"},
                                                             {"0.063", "10"},
                                                             {"0.2", "15"},
                                                             {"0.63", "21"},
                                                             {"2", "28"},
                                                             {"6.3", "36"},
                                                             {"20", "45"},
                                                             {"63", "55"},
                                                             {"200", "70"},
                                                             {"630", "90"},
                                                             {"1000", "100"}}));
  CHECK(share(f, "clay") == percent(1));
  CHECK(share(f, "fine silt") == percent(2));
  CHECK(share(f, "medium silt") == percent(3));
  CHECK(share(f, "coarse silt") == percent(4));
  CHECK(share(f, "silt") == percent(9));
  CHECK(share(f, "fine sand") == percent(5));
  CHECK(share(f, "medium sand") == percent(6));
  CHECK(share(f, "coarse sand") == percent(7));
  CHECK(share(f, "sand") == percent(18));
  CHECK(share(f, "fine gravel") == percent(8));
  CHECK(share(f, "medium gravel") == percent(9));
  CHECK(share(f, "coarse gravel") == percent(10));
  CHECK(share(f, "gravel") == percent(27));
  CHECK(share(f, "cobbles") == percent(15));
  CHECK(share(f, "boulders") == percent(20));
  CHECK(share(f, "large boulders") == percent(10));
}

TEST_CASE("bounds that are no sieve are interpolated and told") {
  const GradingCurve c = curve({{"0.25", "0"}, {"16", "60"}, {"32", "100"}});
  const std::vector<Fraction> f = iso_14688_fractions(c);
  CHECK(*share_between(c, 1, Rational(2))->exact() == percent(10)); // 60 % over 6 octaves
  CHECK(share(f, "gravel") == percent(70));
  CHECK(share(f, "cobbles") == Rational(0));
  CHECK(share(f, "silt") == Rational(0));
  CHECK_FALSE(share(f, "fine gravel"));
  CHECK(interpolated_bounds(c, f) == std::vector<Rational>{20, decimal("6.3"), 2, decimal("0.63")});
}

TEST_CASE("inside a pan at size 0 fractions are not available") {
  const GradingCurve c = curve({{"0", "0"}, {"0.15", "4"}, {"2", "60"}, {"19", "100"}});
  const std::vector<Fraction> f = uscs_fractions(c);
  CHECK_FALSE(named(f, "fines").share);
  CHECK_FALSE(named(f, "sand").share);
  CHECK(named(f, "fines").share.why().reason == "below 0.15 mm, the finest sieve");
  CHECK(named(f, "gravel").share);
  CHECK(share(f, "coarse gravel") == Rational(0));
  CHECK(share(f, "cobbles") == Rational(0));
  CHECK(interpolated_bounds(c, f) == std::vector<Rational>{decimal("4.75"), decimal("0.425")});
}

} // namespace fractions_test
