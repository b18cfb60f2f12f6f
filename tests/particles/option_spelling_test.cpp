// What the readers and writers of particles say of options, as each front end spells them.

#include "particles/particle_writer.hpp"
#include "plain_gradation.hpp"
#include "spellings.hpp"
#include "support.hpp"

#include <mdm/match/solve.hpp>

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

namespace {

auto refusal_of_file(std::string content, ParticleOptions options = {}) {
  return [content = std::move(content), options = std::move(options)] {
    return refusal_of([&] { test::read(content, options); });
  };
}

} // namespace

TEST_CASE("A file of particles is refused in the spelling of the front end") {
  ParticleOptions metres;
  metres.unit = SizeUnit::m;
  check_spellings(refusal_of_file("size_mm,quantity\n1,2\n", metres),
                  {"leave out --size-unit", "leave out size_unit", "leave out sizeUnit"});
  metres.unit_option = "unit"; // of a gradation
  check_spellings(refusal_of_file("size_mm,quantity\n1,2\n", metres),
                  {"leave out --unit", "leave out unit", "leave out unit"});
  ParticleOptions second;
  second.timestep = 2;
  check_spellings(refusal_of_file("1\n", second),
                  {":1: --timestep is for dumps", ":1: timestep is for dumps", ":1: timestep is for dumps"});
  // `from` is a word of Python.
  check_spellings(refusal_of_file("1\n1 2\n"), {"or give --from", "or give from_format", "or give from"});
}

TEST_CASE("A start that has no room is refused in the spelling of the front end") {
  ParticleSetOptions metres;
  metres.unit = SizeUnit::m;
  const ParticleSet set = particle_set(solve(gradation({1, 2, 3}, {1, 1, 0})), metres);
  const auto start = [&set](const Footprint &floor, Start kind) {
    return [&set, floor, kind] { return refusal_of([&] { Placement(set, floor, 1, kind); }); };
  };
  check_spellings(start({ratio(1, 10000), 1, std::nullopt}, Start::layers),
                  {"give a --box that", "give a box that", "give a box that"});
  check_spellings(
      start({ratio(1, 10000), 1, std::nullopt}, Start::deposit),
      {"--start deposit: the footprint", "start deposit: the footprint", "start deposit: the footprint"});
}

TEST_CASE(
    "A particle whose mass no number has within what is allowed is refused in the front end's spelling") {
  ParticleSetOptions exact;
  exact.most_mass_error = ratio(1, power_of_ten(40));
  const Match match = solve(gradation({1, 2, 3}, {1, 2, 0}));
  const auto refusal = [&] { return refusal_of([&] { particle_set(match, exact); }); };
  check_spellings(refusal, {"a larger --mass-error, or take another --unit or --scale",
                            "a larger mass_error, or take another unit or scale",
                            "a larger massError, or take another unit or scale"});
}

} // namespace option_spelling_test
