// Filters by the rules of practice: limits worked out by hand, categories at their bounds, and curves that
// are read point by point in double.

#include "catch.hpp"
#include "judge/filter.hpp"
#include "soils.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace filter_test {

using namespace mdm;
using namespace judge_test;

namespace {

const std::vector<std::string> filter_sieves = {"9.5", "4.75", "2.36", "1.18", "0.6", "0.3", "0.15", "0.075"};
const UnderstoodGradation &sand() {
  static const UnderstoodGradation report =
      soil(filter_sieves, {"100", "96", "80", "60", "35", "15", "5", "1"});
  return report;
}

const std::vector<std::string> base_sieves = {"4.75",  "2",    "0.425", "0.25", "0.15",
                                              "0.075", "0.02", "0.005", "0.001"};

UnderstoodGradation base_of_fines(const std::string &fines) {
  return soil(base_sieves, {"100", "100", "99", "98", "97", fines, "9", "5", "0"});
}

RuleReport judged(const UnderstoodGradation &filter, const UnderstoodGradation &base, FilterOptions options) {
  return judge_filters({filter}, base, options, Rational(0));
}

const Requirement &requirement(const RuleReport &r, const std::string &name) {
  const std::vector<Requirement> &all = r.samples.at(0).requirements;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Requirement &q) { return q.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

double middle(const std::optional<Real> &y) {
  REQUIRE(y);
  return static_cast<double>(enclose(*y, 12).lower());
}

double category(const RuleReport &r) {
  return middle(r.numbers.at(0).value);
}

Points ascending(const std::vector<std::string> &sizes, const std::vector<int> &tenths) {
  Points points;
  for (std::size_t i = sizes.size(); i-- > 0;)
    points.emplace_back(std::stod(sizes[i]), tenths[i] / 10.0);
  return points;
}

std::vector<std::string> texts(const std::vector<int> &tenths) {
  std::vector<std::string> all;
  for (const int t : tenths)
    all.push_back(of_tenths(t));
  return all;
}

/// The greatest D15 by the tables, in double.
double retention_by_tables(double fines, double d85, bool dispersive) {
  const double least = dispersive ? 0.5 : 0.7;
  if (fines > 85)
    return std::max(0.2, (dispersive ? 6.5 : 9) * d85);
  if (fines >= 40)
    return least;
  if (fines >= 15)
    return (40 - fines) / 25 * (std::max(4 * d85, least) - least) + least;
  return 4 * d85;
}

} // namespace

TEST_CASE("Terzaghi asks for D15 between 4 x d15 and 4 x d85 of the base, ends included", "[filter]") {
  // d15 = 0.075 mm, d85 = 0.15 mm; the filter has D15 = 0.6 mm = 4 x d85, then less and more.
  const UnderstoodGradation base = soil({"0.3", "0.15", "0.075", "0.02"}, {"100", "85", "15", "0"});
  const auto with = [&](const std::string &d15) {
    return judged(soil({"4", d15, "0.1"}, {"100", "15", "0"}), base, {FilterRule::terzaghi, false, true});
  };
  CHECK(with("0.6").verdict() == Compliance::holds);
  CHECK(with("0.3").verdict() == Compliance::holds);
  CHECK(requirement(with("0.60000000000000000001"), "retention").verdict == Compliance::fails);
  CHECK(requirement(with("0.60000000000000000001"), "permeability").verdict == Compliance::holds);
  CHECK(requirement(with("0.29999999999999999999"), "permeability").verdict == Compliance::fails);
  CHECK(with("0.6").samples.at(0).requirements.size() == 2);
}

TEST_CASE("the category of a base follows its fines, at the bounds too", "[filter]") {
  const auto of = [](const std::string &fines) {
    return category(judged(sand(), base_of_fines(fines), {FilterRule::fema, false, true}));
  };
  CHECK(of("85.0001") == 1);
  CHECK(of("85") == 2);
  CHECK(of("40") == 2);
  CHECK(of("39.9999") == 3);
  CHECK(of("15") == 3);
  CHECK(of("14.9999") == 4);
}

TEST_CASE("limits of D15 are those of the tables", "[filter]") {
  std::mt19937 random(7);
  std::vector<int> seen(5, 0);
  for (int i = 0; i < 400; ++i) {
    std::vector<int> tenths = random_tenths(random, base_sieves.size(), 0);
    std::sort(tenths.rbegin(), tenths.rend());
    if (i % 5 == 0) // much is finer than 0.075 mm
      for (std::size_t s = 0; s < 6; ++s)
        tenths[s] = std::max(tenths[s], 860);
    tenths.back() = 0;
    const bool dispersive = i % 2 == 1;
    const RuleReport r =
        judged(sand(), soil(base_sieves, texts(tenths)), {FilterRule::usbr, dispersive, true});
    const Points points = ascending(base_sieves, tenths);
    const double fines = percent_at(points, 0.075), d85 = size_at(points, 85), d15 = size_at(points, 15);
    CAPTURE(i);
    CHECK(middle(requirement(r, "retention").limit) == Approx(retention_by_tables(fines, d85, dispersive)));
    CHECK(middle(requirement(r, "permeability").limit) == Approx(std::max(0.1, 5 * d15)));
    const bool retains = 0.3 <= middle(requirement(r, "retention").limit);
    CHECK((requirement(r, "retention").verdict == Compliance::holds) == retains);
    ++seen[static_cast<std::size_t>(category(r))];
  }
  for (std::size_t c = 1; c <= 4; ++c)
    CHECK(seen[c] > 5);
}

TEST_CASE("a base is regraded to what passes 4.75 mm, but not its d15", "[filter]") {
  const UnderstoodGradation base = soil({"75", "19", "4.75", "0.425", "0.075", "0.02", "0.005"},
                                        {"100", "70", "50", "40", "20", "5", "0"});
  const RuleReport regraded = judged(sand(), base, {FilterRule::nrcs, false, true});
  // A = 20/50 = 40 %: category 2. As it is A = 20 %: category 3.
  CHECK(category(regraded) == 2);
  CHECK(middle(regraded.numbers.at(1).value) == Approx(40));
  CHECK(regraded.numbers.at(2).name == "d85, regraded");
  CHECK(middle(regraded.numbers.at(2).value) ==
        Approx(0.425 * std::pow(4.75 / 0.425, (0.85 * 50 - 40) / 10)));
  const RuleReport as_it_is = judged(sand(), base, {FilterRule::nrcs, false, false});
  CHECK(category(as_it_is) == 3);
  CHECK(as_it_is.numbers.at(2).name == "d85");
  CHECK(middle(regraded.numbers.at(3).value) == middle(as_it_is.numbers.at(3).value));
  CHECK(middle(requirement(regraded, "permeability").limit) ==
        Approx(5 * 0.02 * std::pow(0.075 / 0.02, 10.0 / 15)));
  CHECK(
      middle(requirement(judged(sand(), base, {FilterRule::nrcs_1994, false, true}), "permeability").limit) ==
      Approx(4 * 0.02 * std::pow(0.075 / 0.02, 10.0 / 15)));
}

TEST_CASE("fines, the largest size and segregation have limits", "[filter]") {
  const UnderstoodGradation base = base_of_fines("50");
  const auto verdict = [&](const std::vector<std::string> &sizes, const std::vector<std::string> &passing,
                           const char *name, FilterRule rule) {
    return requirement(judged(soil(sizes, passing), base, {rule, false, true}), name).verdict;
  };
  CHECK(verdict({"9.5", "0.3", "0.075"}, {"100", "15", "5"}, "fines", FilterRule::fema) == Compliance::holds);
  CHECK(verdict({"9.5", "0.3", "0.075"}, {"100", "15", "5.01"}, "fines", FilterRule::fema) ==
        Compliance::fails);
  CHECK(verdict({"9.5", "0.3"}, {"100", "15"}, "fines", FilterRule::fema) == Compliance::hangs);
  CHECK(verdict({"51", "0.3", "0.075"}, {"100", "15", "0"}, "largest size", FilterRule::usbr) ==
        Compliance::holds);
  CHECK(verdict({"51.01", "0.3", "0.075"}, {"100", "15", "0"}, "largest size", FilterRule::usbr) ==
        Compliance::fails);
  CHECK(verdict({"75", "0.3", "0.075"}, {"100", "15", "0"}, "largest size", FilterRule::nrcs) ==
        Compliance::holds);
  // D10 below 0.5 mm: D90 up to 20 mm; at 0.5 mm up to 25 mm; at 1 mm still 25 mm; above 30 mm.
  const auto segregates = [&](const char *d10, const char *d90) {
    return verdict({"40", d90, d10, "0.075"}, {"100", "90", "10", "0"}, "segregation", FilterRule::fema);
  };
  CHECK(segregates("0.49", "20") == Compliance::holds);
  CHECK(segregates("0.49", "20.1") == Compliance::fails);
  CHECK(segregates("0.5", "25") == Compliance::holds);
  CHECK(segregates("1", "25.1") == Compliance::fails);
  CHECK(segregates("1.01", "30") == Compliance::holds);
}

TEST_CASE("sizes in the pan hang, unless every size there decides", "[filter]") {
  // d15 of the base is below 0.075 mm: at least 0.1 mm is asked for, at most 0.375 mm.
  const UnderstoodGradation base = soil({"4.75", "0.075"}, {"100", "50"});
  const auto permeability = [&](const std::string &d15) {
    return requirement(
               judged(soil({"4", d15, "0.05"}, {"100", "15", "0"}), base, {FilterRule::fema, false, true}),
               "permeability")
        .verdict;
  };
  CHECK(permeability("0.375") == Compliance::holds);
  CHECK(permeability("0.3") == Compliance::hangs);
  CHECK(permeability("0.099") == Compliance::fails);
}

TEST_CASE("a rounded category makes the verdict hang where it matters", "[filter]") {
  // 85 rounded to whole percents may be category 1 or 2.
  const UnderstoodGradation base = soil({"0.3", "0.15", "0.075", "0.02"}, {"100", "95", "85", "0"});
  const RuleReport r = judge_filters({sand()}, base, {FilterRule::fema, false, true}, Rational(1));
  CHECK_FALSE(r.numbers.at(0).value);
  CHECK(requirement(r, "retention").verdict == Compliance::holds); // 0.3 mm is below both limits
  const UnderstoodGradation coarse = soil({"4", "0.69", "0.3"}, {"100", "15", "0"});
  CHECK(requirement(judge_filters({coarse}, base, {FilterRule::fema, false, true}, Rational(1)), "retention")
            .verdict == Compliance::hangs);
}

TEST_CASE("Terzaghi's rule refuses what it does not have", "[filter]") {
  const UnderstoodGradation base = base_of_fines("50");
  CHECK_THROWS_AS(judged(sand(), base, {FilterRule::terzaghi, true, true}), InputError);
  CHECK_THROWS_AS(judged(sand(), base, {FilterRule::terzaghi, false, false}), InputError);
}

TEST_CASE("a base of which nothing passes 4.75 mm is refused", "[filter]") {
  const UnderstoodGradation gravel = soil({"75", "19"}, {"100", "0"});
  CHECK_THROWS_AS(judged(sand(), gravel, {FilterRule::fema, false, true}), InputError);
}

TEST_CASE("rules of filters have names", "[filter]") {
  for (const FilterRule rule :
       {FilterRule::terzaghi, FilterRule::usbr, FilterRule::nrcs, FilterRule::nrcs_1994, FilterRule::fema})
    CHECK(filter_rule(name(rule)) == rule);
  CHECK_FALSE(filter_rule("bs"));
}

} // namespace filter_test
