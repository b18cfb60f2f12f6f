#include "catch.hpp"

#include <mdm/blend/blend_problem.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

namespace blend_problem_test {

using namespace mdm;

namespace {

Gradation stockpile(const std::string &rows, const std::string &name = "A") {
  return read_gradation("size_mm,passing_percent\n" + rows, name + ".csv");
}

Envelope limits(const std::string &rows) {
  return read_envelope("size_mm,passing_min_percent,passing_max_percent\n" + rows, "limits.csv");
}

std::string refusal(const std::vector<Gradation> &stockpiles, const Envelope &e,
                    const std::optional<Gradation> &target = std::nullopt) {
  try {
    blend_problem(stockpiles, e, target);
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("what passes between two sieves is linear in size, and exact elsewhere") {
  const Gradation g = stockpile("8,100\n4,70\n2,50\n1,50\n0.5,0\n");
  CHECK(passing_at(g, 16)->percent == 100);
  CHECK(passing_at(g, 8)->percent == 100);
  CHECK(passing_at(g, 4)->percent == 70);
  CHECK_FALSE(passing_at(g, 4)->interpolated);
  CHECK(passing_at(g, 3)->percent == 60);
  CHECK(passing_at(g, 3)->interpolated);
  CHECK(passing_at(g, ratio(3, 2))->percent == 50);
  CHECK_FALSE(passing_at(g, ratio(3, 2))->interpolated);
  CHECK(passing_at(g, ratio(1, 4))->percent == 0);
}

TEST_CASE("what passes below the finest sieve is not guessed") {
  const Gradation g = stockpile("8,100\n4,70\n");
  CHECK_FALSE(passing_at(g, 2));
  CHECK_FALSE(passing_at(g, ratio(1, 1000)));
  CHECK(passing_at(g, 0)->percent == 0);
}

TEST_CASE("a problem has the sieves of the specification, whatever those of the stockpiles and the units") {
  const Gradation a = stockpile("8,100\n4,70\n1,10\n", "A");
  const Gradation b = read_gradation("size_um,passing_percent\n4000,100\n2000,40\n1000,20\n", "B.csv");
  const BlendProblem p = blend_problem({a, b}, limits("4,60,90\n2,20,50\n"));
  REQUIRE(p.sieves.size() == 2);
  CHECK(p.sieves[0].size == 2);
  CHECK(p.sieves[1].most == 90);
  CHECK(p.stockpiles[0].passing == std::vector<Rational>{30, 70});
  CHECK(p.stockpiles[1].passing == std::vector<Rational>{40, 100});
  REQUIRE(p.notes.size() == 3); // of the pans, too
  CHECK(p.notes[1] == "A: what passes 2 mm is interpolated between its sieves, linear in size");
}

TEST_CASE("a sieve without limits that a stockpile does not know is left out with a note") {
  const BlendProblem p = blend_problem({stockpile("8,100\n4,70\n")}, limits("4,60,90\n1,0,100\n"));
  CHECK(p.sieves.size() == 1);
  REQUIRE(p.notes.size() == 2); // of the pan, too
  CHECK(p.notes[0].find("1 mm is left out") == 0);
}

TEST_CASE("a limit where a stockpile does not tell what passes is refused") {
  CHECK(refusal({stockpile("8,100\n4,70\n")}, limits("4,60,90\n1,0,20\n"))
            .find("A: what passes 1 mm is not known") == 0);
  CHECK(refusal({stockpile("8,100\n1,70\n")}, limits("4,60,90\n"), stockpile("8,100\n6,50\n", "T"))
            .find("T: what passes 4 mm is not known") == 0);
}

TEST_CASE("stockpiles of one name, and a specification without limits, are refused") {
  CHECK(refusal({stockpile("8,100\n4,70\n"), stockpile("8,100\n4,60\n")}, limits("4,60,90\n"))
            .find("two stockpiles have the name 'A'") == 0);
  CHECK(refusal({stockpile("8,100\n4,70\n")}, limits("1,0,100\n")).find("no sieve") != std::string::npos);
  CHECK(refusal({stockpile("8,100\n4,70\n")}, limits("0,0,100\n")).find("no sieve") != std::string::npos);
}

TEST_CASE("openings of fractional phi are refused with the remedy") {
  const Gradation g = read_gradation("size_phi,mass\n-2,0\n-1.5,1\n-1,2\n", "phi.csv");
  CHECK(refusal({g}, limits("3,10,90\n")).find("mdm convert") != std::string::npos);
}

TEST_CASE("limits in words") {
  BlendProblem p = blend_problem({stockpile("8,100\n4,70\n")}, limits("4,60.5,90\n"));
  p.stockpiles[0].most = ratio(2, 5);
  using Kind = BlendLimit::Kind;
  CHECK(in_words({Kind::passing, 0, false}, p) == "at least 60.5 % passing 4 mm");
  CHECK(in_words({Kind::passing, 0, true}, p) == "at most 90 % passing 4 mm");
  CHECK(in_words({Kind::share, 0, true}, p) == "at most 40 % of A");
  CHECK(limits_of(p).size() == 3);
}

} // namespace blend_problem_test
