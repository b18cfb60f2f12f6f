#include "support.hpp"

#include <mdm/gradation/mass_law.hpp>

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
