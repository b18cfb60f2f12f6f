#include "support.hpp"

namespace root_size_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const Reading rounded_phi{.phi = PhiReading::rounded};

/// 2^(n/degree).
RootSize root_of_two(unsigned n, unsigned degree) {
  return {Rational(power(Integer(2), n)), degree};
}

bool names(const std::string &decimal, const RootSize &x) {
  return x.is_named_by(parse_decimal(decimal));
}

std::string texts(const Gradation &g) {
  std::string all;
  for (std::size_t j = 0; j <= g.classes(); ++j)
    all += (j == 0 ? "" : " ") + g.opening_text(j);
  return all;
}

const std::string half_phi = "size_phi,mass\n-2,0\n-1.5,1\n-1,0\n-0.5,0\n0,1\n";

} // namespace

TEST_CASE("a root is shown exactly, or with 15 digits") {
  CHECK(root_of_two(4, 2).text() == "4");
  CHECK(root_of_two(3, 2).text() == "2.82842712474619");
  CHECK(RootSize{ratio(1, 2), 2}.text() == "0.707106781186548");
  CHECK(RootSize{power(ratio(1, 2), 41), 2}.text() == "0.000000674349576174305");
  CHECK(root_of_two(201, 2).text() == "1792728671193160000000000000000");
  CHECK(RootSize{0, 2}.text() == "0");
  CHECK(RootSize{ratio(3, 2)}.text() == "1.5");
}

TEST_CASE("a decimal of up to 15 digits names the irrational root next to it, and no other") {
  CHECK(names("4", root_of_two(4, 2)));
  CHECK_FALSE(names("4.00000000000001", root_of_two(4, 2)));
  CHECK(names("2.82842712474619", root_of_two(3, 2)));
  CHECK_FALSE(names("2.8284271247462", root_of_two(3, 2)));
  CHECK_FALSE(names("2.82842712474618", root_of_two(3, 2)));
  CHECK_FALSE(names("2.828427124746190", root_of_two(4, 2)));
  CHECK_FALSE(names("2.8284271247461901", root_of_two(3, 2))); // 17 digits
  CHECK_FALSE(names("0", root_of_two(3, 2)));
  CHECK(names("1792728671193160000000000000000", root_of_two(201, 2)));
}

TEST_CASE("roots are compared exactly, whatever their degrees") {
  CHECK(compare(root_of_two(3, 2), root_of_two(6, 4)) == 0);
  CHECK(compare(root_of_two(3, 2), RootSize{parse_decimal("2.82842712474619")}) > 0);
  CHECK(compare(root_of_two(3, 2), RootSize{parse_decimal("2.8284271247462")}) < 0);
  CHECK(compare(root_of_two(1, 3), root_of_two(1, 2)) < 0);
  CHECK(compare(RootSize{0, 2}, RootSize{0, 5}) == 0);
  CHECK(bounds(root_of_two(3, 2)).lo < bounds(root_of_two(3, 2)).hi);
  CHECK(compare(root_of_two(3, 2), RootSize{bounds(root_of_two(3, 2)).lo}) > 0);
  CHECK(compare(root_of_two(3, 2), RootSize{bounds(root_of_two(3, 2)).hi}) < 0);
}

TEST_CASE("openings of half-phi are square roots of powers of 2") {
  const Gradation g = read(half_phi);
  CHECK(g.root() == 2);
  CHECK(text(g.powers()) == "1 2 4 8 16");
  CHECK(texts(g) == "1 1.4142135623731 2 2.82842712474619 4");
  CHECK(g.notes().empty());
}

TEST_CASE("the root of a file of phi is the common denominator of all its rows") {
  CHECK(read("size_phi,mass\n-1,0\n0,1\npan,1\n").root() == 1);
  CHECK(read("size_phi,mass\n-1,0\n0.50,1\npan,1\n").root() == 2);
  CHECK(read("size_phi,mass\n-0.25,0\n0.2,1\n").root() == 20);
  CHECK(text(read("size_phi,mass\n-0.25,0\n0.2,1\npan,1\n").powers()) == "0 0.0625 32");
  CHECK(read("size_phi,mass\n-0.001,0\n0,1\n").root() == 1000);
}

TEST_CASE("phi beyond roots of degree 1000 is refused, with the conversion as the remedy") {
  for (const std::string phi : {"0.0001", "1e-400"})
    CHECK(contains(refusal("size_phi,mass\n-1,0\n" + phi + ",1\n"), "sand.csv:3: size_phi '" + phi + "'"));
  CHECK(contains(refusal("size_phi,mass\n-1,0\n0.0001,1\n"), "mdm convert writes the openings in mm"));
  CHECK(
      contains(refusal("size_phi,mass\n-1,0\n1000.5,1\n"), "sand.csv:3: size_phi phi 1000.5 is beyond 1000"));
}

TEST_CASE("only where the user says so, phi is rounded") {
  const Gradation g = read_gradation(half_phi, "sand.csv", rounded_phi);
  CHECK(g.root() == 1);
  CHECK(text(g.sizes()) == "1 1.4142135623731 2 2.82842712474619 4");
  REQUIRE(g.notes().size() == 1);
  CHECK(contains(g.notes()[0], "rounded to 15 significant digits in mm: phi '-1.5', '-0.5'"));
  CHECK(read_gradation("size_phi,mass\n-1,0\n0.0001,1\n", "s", rounded_phi).root() == 1);
}

TEST_CASE("where only fractions will do, irrational openings are refused and not rounded") {
  const std::string refused = "mdm convert writes the openings in mm, rounded to 15 digits";
  CHECK(contains(message_of([] { read(half_phi).sizes(); }), refused));
  CHECK(contains(message_of([] { read(half_phi).lower(0); }), refused));
  CHECK(contains(message_of([] { gradation_csv(read(half_phi)); }), refused));
  CHECK(contains(message_of([] { gradation_json(read(half_phi)); }), refused));
}

TEST_CASE("irrational openings are cut at by their name, and changed exactly") {
  const Gradation g = read(half_phi);
  CHECK(text(g.cut_below(parse_decimal("1.4142135623731")).powers()) == "2 4 8 16");
  CHECK(text(g.cut_below(2).powers()) == "4 8 16");
  CHECK(g.cut_below(2).root() == 2);
  CHECK(contains(message_of([&] { g.cut_below(parse_decimal("1.414213562373")); }),
                 "there is no sieve of 1.414213562373 mm to cut at: the sieves are 1, 1.4142135623731, 2,"));
  CHECK(text(g.scaled(3).powers()) == "9 18 36 72 144");
  const Gradation with_pan = read("size_phi,mass\n-1.5,0\n-0.5,1\npan,1\n");
  CHECK(text(with_pan.with_pan_size(parse_decimal("1.4")).powers()) == "1.96 2 8");
  CHECK(contains(message_of([&] { with_pan.with_pan_size(parse_decimal("1.4142135623731")); }),
                 "must lie between 0 and the finest sieve, 1.4142135623731 mm"));
}

TEST_CASE("equal sizes of phi are found, and messages show openings") {
  CHECK(contains(refusal("size_phi,mass\n-1.5,0\n0.50,1\n.5,1\n"),
                 "sand.csv:4: size 0.707106781186548 mm repeats that of line 3"));
  CHECK(contains(refusal("size_phi,mass\n-1.5,1\n0,1\n"),
                 "the largest sieve, 2.82842712474619 mm, has mass 1"));
}

} // namespace root_size_test
