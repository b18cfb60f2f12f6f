#include "support.hpp"

#include <mdm/gradation/mass_law.hpp>

namespace mass_law_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("Mass law: sphere and powers in lowest terms") {
  CHECK(parse_mass_law("sphere") == MassLaw{3, 1});
  CHECK(parse_mass_law("power:3").is_sphere());
  CHECK(parse_mass_law("power:6/2").is_sphere());
  CHECK(parse_mass_law("power:5/2") == MassLaw{5, 2});
  CHECK(parse_mass_law("power:2.5") == MassLaw{5, 2});
  CHECK(parse_mass_law("power:1000/1") == MassLaw{1000, 1});
  CHECK(parse_mass_law("power:2000/4000") == MassLaw{1, 2});
  CHECK(parse_mass_law("power:0.001") == MassLaw{1, 1000});
  CHECK(MassLaw{5, 2}.exponent() == "5/2");
  CHECK(MassLaw{}.exponent() == "3");
  CHECK(MassLaw{2, 3}.powered(ratio(3, 2)) == ratio(9, 4));
}

TEST_CASE("Mass law: anything else is refused") {
  for (const std::string law :
       {"", "cube", "Sphere", "power:", "power:0", "power:0/1", "power:1/0", "power:-3", "power:3/-1",
        "power:1001", "power:1/1001", "power:2.5/2", "power:3/", "power:/3", "power:3/1/1", "power:nan",
        "power:1e400", "power: 3"})
    CHECK(contains(message_of([&law] { parse_mass_law(law); }),
                   in_quotes(law) + " is no mass law: write 'sphere', or"));
}

namespace {

std::string table_message(const std::string &csv) {
  return message_of([&csv] { read_law_table(csv, "law.csv"); });
}

} // namespace

TEST_CASE("Mass law: sums of powers") {
  const MassLaw law = parse_mass_law("sum:2*x^3+0.5*x^2");
  CHECK(law == MassLaw{1, 1, {}, {{2, 3}, {ratio(1, 2), 2}}});
  CHECK(law == parse_mass_law("sum: 1/2*x^2 + 2*x^3 + 0*x"));
  CHECK(law == parse_mass_law("sum:x^3+1/4*x^2+x^3+0.25*x^2"));
  CHECK(parse_mass_law("sum:x").sum == std::vector<LawTerm>{{1, 1}});
  CHECK_FALSE(law.is_power());
  CHECK_FALSE(parse_mass_law("sum:1*x^3").is_sphere());
  CHECK(law.powered(0) == 0);
  CHECK(law.powered(ratio(3, 2)) == ratio(63, 8));
  CHECK(law.formula(SizeUnit::um) == "2*x^3 + 1/2*x^2, x in um");
  CHECK(law.scaled(1000).powered(1500) == ratio(63, 8));
  CHECK(law.steepness() == 3);
  for (const std::string sum : {"sum:", "sum:x^0", "sum:x^3+", "sum:-1*x^3", "sum:2x^3", "sum:x^1.5", "sum:3",
                                "sum:x^1001", "sum:1/0*x", "sum:x**2"})
    CHECK(contains(message_of([&sum] { parse_mass_law(sum); }), "is no term c*x^n"));
  CHECK(contains(message_of([] { parse_mass_law("sum:0*x^3"); }), "is 0 for every size"));
  std::string many = "sum:x";
  for (int n = 2; n <= 17; ++n)
    many += "+x^" + std::to_string(n);
  CHECK(contains(message_of([&many] { parse_mass_law(many); }), "more than 16 powers"));
}

TEST_CASE("Mass law: tables") {
  const MassLaw law = read_law_table("size_mm,particle_mass\n0,0\n0.5,1\n2,70\n", "law.csv");
  CHECK(law == MassLaw{1, 1, {{ratio(1, 2), 1}, {2, 70}}, {}});
  CHECK(law == read_law_table("size_mm;particle_mass\n0,5;1\n2;70\n", "law.csv"));
  CHECK(law.powered(0) == 0);
  CHECK(law.powered(ratio(1, 4)) == ratio(1, 2));
  CHECK(law.powered(ratio(1, 2)) == 1);
  CHECK(law.powered(1) == 24);
  CHECK(law.powered(2) == 70);
  CHECK(contains(message_of([&law] { law.powered(ratio(21, 10)); }), "2.1 is beyond the table"));
  CHECK(law.formula(SizeUnit::mm) == "by the table 0.5 mm: 1, 2 mm: 70");
  CHECK(law.scaled(1000).powered(1000) == 24);
  CHECK(law.steepness() == 23); // 46 * 0.5 / 1
  for (const auto &[rows, what] : {std::pair("1,1\n1,2\n", "law.csv:3: size 1 is not above"),
                                   {"1,1\n2,1\n", "law.csv:3: particle_mass 1 is not"},
                                   {"2,1\n1,2\n", "law.csv:3: size 1 is not above"},
                                   {"0,1\n", "law.csv:2: the node (0, 1)"},
                                   {"1,0\n", "law.csv:2: the node (1, 0)"},
                                   {"1,1\n0,0\n", "law.csv:3: the node (0, 0)"},
                                   {"-1,1\n", "law.csv:2: the node (-1, 1)"},
                                   {"1,x\n", "law.csv:2:"},
                                   {"1\n", "law.csv:2: the row has"},
                                   {"", "law.csv:1: there is no node"},
                                   {"0,0\n", "there is no node"}})
    CHECK(contains(table_message(std::string("size_mm,particle_mass\n") + rows), what));
  CHECK(contains(table_message("size_um,particle_mass\n1,1\n"), "law.csv:1: the columns of a mass law are"));
  CHECK(contains(table_message("size_mm,mass\n1,1\n"), "law.csv:1: the columns of a mass law are"));
  CHECK(contains(table_message("size_mm,particle_mass,x\n1,1,1\n"),
                 "law.csv:1: the columns of a mass law are"));
}

} // namespace mass_law_test
