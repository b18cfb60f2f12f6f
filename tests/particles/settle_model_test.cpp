#include "particles/particle_writer.hpp"
#include "particles/settle_model.hpp"
#include "support.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

#include <cmath>
#include <random>
#include <regex>
#include <set>

namespace settle_model_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string sand = "size_mm,mass\n0.038,3.86\n0.076,1.28\n0.11,10.13\n0.15,44.86\n0.25,21.22\n"
                         "0.43,12.05\n0.85,6.6\n2.4,0\n";

ParticleSet set_of(const std::string &csv, const ParticleSetOptions &options = {}) {
  return particle_set(solve(read_gradation(csv, "sand.csv")), options);
}

SettleModel model_of(const ParticleSet &set) {
  return {set, {0.002, 0.002, 0.01}, "sand.data", "sand"};
}

std::vector<std::string> found(const std::string &text, const std::string &pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    all.push_back((*it)[1]);
  return all;
}

std::string refusal_of(const SettleModel &model, std::string (*script)(const SettleModel &)) {
  try {
    script(model);
  } catch (const InputError &error) {
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

constexpr auto scripts = {liggghts_model, lammps_model, yade_model};

} // namespace

TEST_CASE("settling: the time step from the smallest grain, computed by hand") {
  // G = 5e6 / 2.5 Pa, sqrt(2650 / G) = 0.03640055 s/m.
  const ParticleSet one = set_of("size_mm,mass\n1,1\n2,0\n");
  REQUIRE(one.particles() == 1);
  SettleModel model = model_of(one);
  const double radius = one.smallest().radius.value;
  const Settling s = settling(model);
  CHECK(s.elasticity.young == 5000000);
  CHECK(s.rayleigh / radius == Approx(3.14159265 * 0.03640055 / (0.1631 * 0.25 + 0.8766)));
  CHECK(s.step == Approx(s.rayleigh / 5));
  // A fall from 1 cm takes 0.0451524 s; five are given.
  CHECK(static_cast<double>(s.steps) == Approx(5 * 0.0451524 / s.step).epsilon(2e-4));
  // Below 1 m of sand 10^4 times its weight is more than 5 MPa.
  model.box.z = 1;
  CHECK(settling(model).elasticity.young == 259965000);
  model.young = 1000000;
  CHECK(settling(model).elasticity.young == 1000000);
  model.steps = 17;
  CHECK(settling(model).steps == 17);
}

TEST_CASE("insertion height: grains of one size keep at most four fifths of the places free") {
  ParticleSet set = set_of("size_mm,mass\n1,1\n2,0\n");
  set.classes[0].sizes[0].quantity = 100;
  const double d = set.largest().diameter.value;
  const double height = insertion_height(set, 0.01, 0.02);
  const double places = (0.01 - d) * (0.02 - d) * (height - d);
  // No centre lies within d of another.
  CHECK(100 * 4 * 3.14159265 / 3 * d * d * d == Approx(0.8 * places));
}

TEST_CASE("insertion height: a random insertion largest first finds its places") {
  const ParticleSet set = set_of(sand);
  const double side = 0.0018, height = insertion_height(set, side, side);
  struct Ball {
    double x, y, z, r;
  };
  std::vector<Ball> balls;
  std::mt19937_64 random(3);
  const auto place = [&random](double r, double length) {
    return std::uniform_real_distribution<>(r, length - r)(random);
  };
  std::size_t tries = 0;
  for (auto c = set.classes.rbegin(); c != set.classes.rend(); ++c)
    for (Integer n = 0; n < c->quantity(); ++tries) {
      const double r = c->sizes[0].radius.value;
      const Ball ball{place(r, side), place(r, side), place(r, height), r};
      if (std::none_of(balls.begin(), balls.end(), [&ball](const Ball &b) {
            return std::hypot(ball.x - b.x, ball.y - b.y, ball.z - b.z) < ball.r + b.r;
          })) {
        balls.push_back(ball);
        ++n;
      }
    }
  CHECK(tries < 5 * balls.size());
}

TEST_CASE("share tolerance: no shares of masses within their error are further off") {
  const ParticleSet set = set_of(sand);
  const double tolerance = parse_decimal(share_tolerance(set)).convert_to<double>() / 100;
  const double e = set.mass_error().convert_to<double>();
  CHECK(tolerance >= 2 * e);
  CHECK(tolerance <= 5 * e + 1e-14);
  // Half of the mass too heavy by e, the other half too light: the shares are off by e / 2.
  CHECK(std::abs(0.5 * (1 + e) / (0.5 * (1 + e) + 0.5 * (1 - e)) - 0.5) <= tolerance);
}

TEST_CASE("LIGGGHTS and LAMMPS read the grains, and check the count of each class, the largest first") {
  const ParticleSet set = set_of(sand);
  for (const auto script : {liggghts_model, lammps_model}) {
    const std::string text = script(model_of(set));
    CHECK(contains(text, "\"read_data sand.data\""));
    CHECK(!contains(text, "insert/pack"));
    std::vector<std::string> counts = found(text, "\nif \"\\$n != ([0-9]+)\" then");
    REQUIRE(counts.size() > 7);
    counts.resize(7);
    CHECK(counts == std::vector<std::string>{"1", "2", "25", "268", "280", "90", "819"});
    CHECK(contains(text, "gravity 9.81"));
  }
}

TEST_CASE("models: the length of a script does not grow with the sizes of a class") {
  const Match m = solve(read_gradation(sand, "sand.csv"));
  const ParticleSet one = particle_set(m), spread = spread_particle_set(m, 1);
  REQUIRE(spread.classes[0].sizes.size() > 100);
  for (const auto script : scripts)
    CHECK(script(model_of(spread)).size() < script(model_of(one)).size() + 1000);
}

TEST_CASE("models: each space has its walls, and an engine without one refuses it") {
  const ParticleSet set = set_of(sand);
  SettleModel model = model_of(set);
  model.space = Space::cylinder;
  CHECK(contains(liggghts_model(model), " zcylinder ${half} ${half} ${half}\n"));
  CHECK(contains(lammps_model(model), "\nregion inside cylinder z ${half} ${half} ${half} "));
  CHECK(contains(yade_model(model), "geom.facetCylinder("));
  model.space = Space::pillar;
  CHECK(contains(liggghts_model(model), "\nboundary p p f\n"));
  CHECK(contains(lammps_model(model), "\nboundary p p f\n"));
  CHECK(contains(refusal_of(model, yade_model), "take lammps or liggghts"));
  model.space = Space::periodic_cell;
  model.target = DensityTarget{0.6};
  CHECK(contains(lammps_model(model), "\nboundary p p p\n"));
  CHECK(!contains(lammps_model(model), "fix gravity"));
  CHECK(contains(yade_model(model), "O.periodic = True"));
  CHECK(contains(refusal_of(model, liggghts_model), "take lammps or yade"));
}

TEST_CASE("models: the density that is asked for, its tolerance and the friction on the way") {
  const ParticleSet set = set_of(sand);
  SettleModel model = model_of(set);
  model.target = DensityTarget{0.65, 0, 0.02};
  model.friction = 0.4;
  model.friction_while_filling = 0.1;
  for (const auto script : {liggghts_model, lammps_model}) {
    const std::string text = script(model);
    CHECK(found(text, "\nvariable target index ([0-9.]+) +# void ratio\n") ==
          std::vector<std::string>{"0.65"});
    CHECK(found(text, "\nvariable tolerance index ([0-9.]+) ") == std::vector<std::string>{"0.02"});
    CHECK(found(text, "\nvariable friction index ([0-9.]+) ") == std::vector<std::string>{"0.4"});
    CHECK(found(text, "\nvariable friction_while_filling index ([0-9.]+) ") ==
          std::vector<std::string>{"0.1"});
  }
  CHECK(contains(yade_model(model), "\ntarget = 0.65  # void ratio\ntolerance = 0.02  "));
  CHECK(contains(yade_model(model), "\nfriction_while_filling = 0.1  "));
  // 4 mm^2, and solids of pi / 6 sum d^3: the height of the lid by hand.
  const double solids = 3.14159265358979 / 6 * set.cubes().convert_to<double>();
  const std::vector<std::string> height = found(lammps_model(model), "the lid is ([0-9.]+) m above");
  REQUIRE(height.size() == 1);
  CHECK(std::stod(height[0]) == Approx(1.65 * solids / 4e-6));
  model.target = DensityTarget{{}, 20000};
  CHECK(found(lammps_model(model), "\nvariable target index ([0-9.]+) +# Pa\n") ==
        std::vector<std::string>{"20000"});
  // Grains are stiff enough for that pressure.
  CHECK(settling(model).elasticity.young == 40000000);
}

TEST_CASE("triaxial models: the rate of the shear from d50 and the pressure, computed by hand") {
  // One size, so d50 is it; ten grains in a long cell.
  ParticleSet set = set_of("size_mm,mass\n1,1\n2,0\n");
  set.classes[0].sizes[0].quantity = 1000;
  SettleModel model{set, {0.02, 0.02, 0.02}, "sand.data", "sand"};
  model.space = Space::periodic_cell;
  model.target = DensityTarget{{}, 100000};
  model.shear = TriaxialShear{0.1, {}};
  const double d = set.largest().diameter.value, rate = 8e-4 / (d * std::sqrt(2650 / 1e5));
  const std::string lammps = lammps_model(model), yade = yade_model(model);
  for (const std::string &text : {lammps, yade}) {
    const std::vector<std::string> stated = found(text, "the height shrinks by ([0-9.]+) of itself a second");
    REQUIRE(stated.size() == 1);
    CHECK(std::stod(stated[0]) == Approx(rate).epsilon(1e-3));
    CHECK(contains(text, "sand-triaxial.csv"));
    CHECK(contains(text, "sand-sheared."));
    CHECK(!contains(text, "asked_void_ratio"));
    CHECK(!contains(text, "sand-settled"));
    CHECK(found(text, "(@[a-z_]+@)").empty());
  }
  model.shear->void_ratio = 0.62;
  CHECK(found(lammps_model(model), "\nvariable asked_void_ratio index ([0-9.]+) ") ==
        std::vector<std::string>{"0.62"});
  CHECK(contains(yade_model(model), "\nasked_void_ratio = 0.62  #"));
  CHECK(contains(refusal_of(model, liggghts_model), "take lammps or yade"));
  set.classes[0].sizes[0].quantity = 8;
  CHECK(contains(refusal_of(model, lammps_model), "would touch itself"));
  CHECK(contains(refusal_of(model, yade_model), "would touch itself"));
  model.space = Space::six_walls;
  CHECK(contains(refusal_of(model, lammps_model), "take liggghts"));
  CHECK(contains(refusal_of(model, yade_model), "take liggghts"));
}

TEST_CASE("models: a type and a material for each class") {
  const ParticleSet set = set_of(sand);
  SettleModel model = model_of(set);
  model.types_of_classes = true;
  for (std::size_t i = 0; i < set.classes.size(); ++i)
    model.materials.push_back(
        {{Rational(1000000 * (i + 1)), ratio(1, 4)}, 0.5, 0.1 * static_cast<double>(i + 1)});
  CHECK(contains(liggghts_model(model),
                 "youngsModulus peratomtype 1e+06 2e+06 3e+06 4e+06 5e+06 6e+06 7e+06 5e+06\n"));
  CHECK(contains(liggghts_model(model), "mesh/surface/stress file sand-lid.stl type 8 "));
  CHECK(contains(lammps_model(model), "\npair_coeff 1 1 ${contact}\n"));
  CHECK(contains(lammps_model(model), "\npair_coeff 7 8 ${contact}\n"));
  CHECK(contains(yade_model(model), ", 280, 3e+06, 0.25, 0.3, 0.5),\n"));
  CHECK(contains(yade_model(model), "en=restitution()"));
  // The smallest grains are the softest, and set the time step all the same.
  const double of_first = rayleigh_time(set, {1000000, ratio(1, 4)}).convert_to<double>();
  CHECK(settling(model).rayleigh == Approx(of_first));
  model.materials.front().elasticity.young = 100000000;
  CHECK(settling(model).rayleigh == Approx(of_first / 10));
}

TEST_CASE("models: sizes and counts are those of the set") {
  const ParticleSet set = set_of(sand);
  const SettleModel model = model_of(set);
  for (const ParticleClass &c : set.classes) {
    CHECK(contains(liggghts_model(model), "c_d >= " + c.sizes[0].diameter.text + " "));
    CHECK(contains(lammps_model(model), "c_d >= " + c.sizes[0].diameter.text + " "));
    CHECK(contains(yade_model(model), ", " + c.sizes[0].radius.text + ", " + to_string(c.quantity()) + ", "));
  }
}

TEST_CASE("models: a bounded number of steps") {
  const ParticleSet set = set_of(sand);
  SettleModel model = model_of(set);
  model.steps = 1234;
  CHECK(contains(liggghts_model(model), "\nvariable steps index 1234 "));
  CHECK(contains(lammps_model(model), "\nvariable steps index 1234 "));
  CHECK(contains(yade_model(model), " else 1234  #"));
  model.steps = 2147483647;
  CHECK(contains(lammps_model(model), "\nvariable steps index 2147483647 "));
  model.steps = 2147483648;
  for (const auto script : scripts)
    CHECK(contains(refusal_of(model, script), "fewer --steps"));
  model.steps = {};
  model.young = power_of_ten(30);
  for (const auto script : scripts)
    CHECK(contains(refusal_of(model, script), "softer --young"));
}

TEST_CASE("models: the error that they state is not below the one that there is") {
  for (const unsigned places : {3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U}) {
    const ParticleSet set = set_of(sand, {SizeUnit::m, 2650, ratio(1, power_of_ten(places))});
    const std::vector<std::string> stated = found(lammps_model(model_of(set)), "is exact to ([0-9.e-]+) of");
    REQUIRE(stated.size() == 1);
    CHECK(parse_decimal(stated[0]) >= set.mass_error());
    CHECK(parse_decimal(stated[0]) <= set.mass_error() * ratio(101, 100));
  }
  ParticleSet set = set_of(sand);
  const auto stated = [&set](const Rational &error) {
    for (ParticleClass &c : set.classes)
      c.mass_error = error;
    return stated_error(set);
  };
  CHECK(stated(parse_decimal("9.998e-10")) == "1e-9");
  CHECK(stated(parse_decimal("9.98e-10")) == "9.98e-10");
  CHECK(stated(parse_decimal("9.980000001e-10")) == "9.99e-10");
  CHECK(stated(parse_decimal("0.0123")) == "0.0123");
  CHECK(stated(parse_decimal("0.5")) == "0.5");
  CHECK(stated(0) == "0");
}

TEST_CASE("models: nothing of a name is taken for a command") {
  ParticleSet set = set_of(sand);
  set.name = "a\nshell rm &\nb $x `y` '\"\\ \xC3\xA9";
  const SettleModel model = model_of(set);
  for (const auto script : scripts)
    CHECK(contains(script(model), "# a_shell rm __b _x _y_ ___ __: 1485 grains"));
}

TEST_CASE("models: refusals") {
  const ParticleSet set = set_of(sand);
  SettleModel model = model_of(set);
  for (const auto script : scripts) {
    for (const std::string name : {"", "a b", "$x", "a&", "../a", "-a", "\xC3\xA9"}) {
      model.name = name;
      CHECK(contains(refusal_of(model, script), "letters, digits"));
    }
    model.name = "ok";
    CHECK(contains(refusal_of(model_of(set_of(sand, {SizeUnit::mm, 2650, ratio(1, 1000)})), script),
                   "leave out --unit"));
  }
  ParticleSet many = set;
  many.classes[0].sizes[0].quantity = Integer(1) << 31;
  CHECK(contains(refusal_of(model_of(many), liggghts_model), "2147483647 that programs count"));
}

} // namespace settle_model_test
