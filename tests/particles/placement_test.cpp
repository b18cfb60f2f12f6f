#include "particles/particle_writer.hpp"
#include "support.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <unordered_map>

namespace placement_test {

using namespace mdm;
using namespace mdm::test;

namespace {

ParticleSet set_of(const std::string &csv, const Integer &at_least = 1, SizeUnit unit = SizeUnit::m) {
  Question question;
  question.at_least = at_least;
  ParticleSetOptions options;
  options.unit = unit;
  return particle_set(solve(read_gradation(csv, "sand.csv"), question), options);
}

const std::string sand = "size_mm,mass\n0.038,3.86\n0.076,1.28\n0.11,10.13\n0.15,44.86\n0.25,21.22\n"
                         "0.43,12.05\n0.85,6.6\n2.4,0\n";
const std::string narrow = "size_mm,mass\n1,10\n1.4,0\n2,50\n2.8,40\n4,0\n";

template <class Write, class From>
std::string written(Write write, const From &from) {
  std::string text;
  write(from, [&text](std::string_view piece) { text += piece; });
  return text;
}

/// A sphere as a program has it.
struct Ball {
  double x[3], r;
};

std::vector<Ball> read_balls(const std::string &xyzr) {
  std::vector<Ball> balls;
  std::istringstream lines(xyzr);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#')
      continue;
    Ball b{};
    char *at = line.data();
    for (double &x : b.x)
      x = std::strtod(at, &at);
    b.r = std::strtod(at, &at);
    CHECK(*at == '\0');
    balls.push_back(b);
  }
  return balls;
}

bool overlap(const Ball &a, const Ball &b) {
  double square = 0;
  for (int i = 0; i < 3; ++i)
    square += (a.x[i] - b.x[i]) * (a.x[i] - b.x[i]);
  const double reach = (a.r + b.r) * (a.r + b.r);
  if (std::abs(square - reach) > 1e-9 * reach)
    return square < reach;
  Rational exact = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational d = Rational(a.x[i]) - Rational(b.x[i]);
    exact += d * d;
  }
  const Rational radii = Rational(a.r) + Rational(b.r);
  return exact < radii * radii;
}

std::size_t all_pairs(const std::vector<Ball> &balls) {
  std::size_t overlaps = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      overlaps += overlap(balls[i], balls[j]) ? 1U : 0U;
  return overlaps;
}

/// Balls of one radius in cells as wide as they: who meets a ball has the centre within its reach.
std::size_t by_cells(const std::vector<Ball> &balls) {
  using Cells = std::unordered_map<std::uint64_t, std::vector<std::size_t>>;
  const auto key = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    return static_cast<std::uint64_t>((i * 1000003 + j) * 1000003 + k);
  };
  std::map<double, Cells> levels;
  const auto index = [](double x, double cell) { return static_cast<std::int64_t>(std::floor(x / cell)); };
  std::size_t overlaps = 0;
  for (std::size_t n = 0; n < balls.size(); ++n) {
    const Ball &b = balls[n];
    for (const auto &[r, cells] : levels) {
      const double cell = 2 * r, reach = (r + b.r) * 1.0001;
      for (std::int64_t i = index(b.x[0] - reach, cell); i <= index(b.x[0] + reach, cell); ++i)
        for (std::int64_t j = index(b.x[1] - reach, cell); j <= index(b.x[1] + reach, cell); ++j)
          for (std::int64_t k = index(b.x[2] - reach, cell); k <= index(b.x[2] + reach, cell); ++k)
            if (const auto found = cells.find(key(i, j, k)); found != cells.end())
              for (const std::size_t other : found->second)
                overlaps += overlap(b, balls[other]) ? 1U : 0U;
    }
    const double cell = 2 * b.r;
    levels[b.r][key(index(b.x[0], cell), index(b.x[1], cell), index(b.x[2], cell))].push_back(n);
  }
  return overlaps;
}

/// Balls that are not inside the box, as doubles.
std::size_t outside(const std::vector<Ball> &balls, const Placement &start) {
  std::size_t n = 0;
  for (const Ball &b : balls)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double side = std::strtod(start.text(start.box()[axis]).c_str(), nullptr);
      n += Rational(b.x[axis]) < Rational(b.r) || Rational(b.x[axis]) + Rational(b.r) > Rational(side) ? 1U
                                                                                                       : 0U;
    }
  return n;
}

std::string refusal_of(const ParticleSet &set, const std::optional<Footprint> &floor,
                       Start start = Start::layers) {
  try {
    Placement(set, floor, 1, start);
  } catch (const InputError &error) {
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

} // namespace

TEST_CASE("placement: no two particles overlap and all are inside the box") {
  const ParticleSet set = set_of(sand);
  for (const std::optional<Footprint> &floor :
       {std::optional<Footprint>(),
        std::optional<Footprint>({ratio(86, 100000), ratio(9, 1000), std::nullopt}),
        std::optional<Footprint>({ratio(1, 100), ratio(1, 300), std::nullopt})}) {
    for (const std::uint64_t seed : {1U, 2U})
      for (const Start kind : {Start::layers, Start::mixed, Start::deposit}) {
        if (kind == Start::deposit && floor && floor->a < ratio(1, 1000))
          continue; // narrower than three of the largest
        const Placement start(set, floor, seed, kind);
        const std::vector<Ball> balls = read_balls(written(write_xyzr, start));
        CHECK(balls.size() == 1485);
        CHECK(all_pairs(balls) == 0);
        CHECK(by_cells(balls) == 0);
        CHECK(outside(balls, start) == 0);
      }
  }
}

TEST_CASE("placement: the test of overlaps finds them") {
  const ParticleSet set = set_of(sand);
  std::vector<Ball> balls = read_balls(written(write_xyzr, Placement(set, std::nullopt, 1)));
  balls.push_back({{balls[7].x[0], balls[7].x[1], balls[7].x[2] + balls[7].r}, 1e-5});
  CHECK(all_pairs(balls) == 1);
  CHECK(by_cells(balls) == 1);
  // Touching is no overlap, an ulp less is one.
  CHECK_FALSE(overlap({{0, 0, 0}, 1}, {{0, 0, 2}, 1}));
  CHECK(overlap({{0, 0, 0}, 1}, {{0, 0, std::nextafter(2.0, 0.0)}, 1}));
}

TEST_CASE("placement: 100000 particles in a narrow box and in a wide one") {
  const ParticleSet set = set_of(narrow, 100000);
  for (const Rational &side : {ratio(5, 1000), ratio(1, 2)}) {
    const Placement start(set, Footprint{side, side, std::nullopt}, 3);
    const std::vector<Ball> balls = read_balls(written(write_xyzr, start));
    CHECK(Integer(balls.size()) == set.particles());
    CHECK(by_cells(balls) == 0);
    CHECK(outside(balls, start) == 0);
  }
}

TEST_CASE("placement: 100000 particles at random places") {
  const ParticleSet set = set_of(sand, 100000);
  const Placement start(set, std::nullopt, 3, Start::mixed);
  const std::vector<Ball> balls = read_balls(written(write_xyzr, start));
  CHECK(Integer(balls.size()) == set.particles());
  CHECK(by_cells(balls) == 0);
  CHECK(outside(balls, start) == 0);
}

TEST_CASE("placement: a mixed start has each class at all heights") {
  const ParticleSet set = set_of(sand);
  const Placement start(set, std::nullopt, 1, Start::mixed);
  const double height = std::strtod(start.text(start.box()[2]).c_str(), nullptr);
  std::map<double, std::vector<double>> heights;
  for (const Ball &b : read_balls(written(write_xyzr, start)))
    heights[b.r].push_back(b.x[2] / height);
  for (const auto &[r, at] : heights) {
    if (at.size() < 80)
      continue;
    // The mean of n numbers between 0 and 1 is within five of its standard deviations of 1/2.
    double sum = 0;
    for (const double z : at)
      sum += z;
    const auto n = static_cast<double>(at.size());
    CHECK(std::abs(sum / n - 0.5) < 5 / std::sqrt(12 * n));
    CHECK(*std::min_element(at.begin(), at.end()) < 0.1);
    CHECK(*std::max_element(at.begin(), at.end()) > 0.9);
  }
}

TEST_CASE("placement: a mixed start is chosen by its seed") {
  const ParticleSet set = set_of(narrow);
  const auto text = [&set](std::uint64_t seed) {
    return written(write_xyzr, Placement(set, std::nullopt, seed, Start::mixed));
  };
  CHECK(text(1) == text(1));
  CHECK(text(1) != text(2));
}

TEST_CASE("placement: a deposit is dense where layers are loose") {
  const ParticleSet set = set_of(narrow, 20000);
  const Placement layers(set, std::nullopt, 1), deposit(set, std::nullopt, 1, Start::deposit);
  CHECK(layers.void_ratio().first > ratio(3, 2) * deposit.void_ratio().second);
  CHECK(deposit.void_ratio().second < 1);
  CHECK(deposit.void_ratio().first > ratio(1, 2));
  const std::vector<Ball> balls = read_balls(written(write_xyzr, deposit));
  CHECK(Integer(balls.size()) == set.particles());
  CHECK(by_cells(balls) == 0);
  CHECK(outside(balls, deposit) == 0);
}

TEST_CASE("placement: a deposit of 30000 particles of sizes sixty times apart") {
  const ParticleSet set = set_of(sand, 30000);
  const Placement start(set, std::nullopt, 3, Start::deposit);
  const std::vector<Ball> balls = read_balls(written(write_xyzr, start));
  CHECK(Integer(balls.size()) == set.particles());
  CHECK(by_cells(balls) == 0);
  CHECK(outside(balls, start) == 0);
}

TEST_CASE("placement: a deposit in a cylinder is inside of it, and its void ratio is that of the cylinder") {
  const ParticleSet set = set_of(narrow, 500);
  const Rational diameter = ratio(2, 100);
  const Placement start(set, Footprint{diameter, diameter, std::nullopt, Sides::cylinder}, 1, Start::deposit);
  const std::vector<Ball> balls = read_balls(written(write_xyzr, start));
  CHECK(all_pairs(balls) == 0);
  const Rational radius = Rational(std::strtod(start.text(start.box()[0]).c_str(), nullptr)) / 2;
  double solids = 0;
  for (const Ball &b : balls) {
    const Rational x = Rational(b.x[0]) - radius, y = Rational(b.x[1]) - radius,
                   room = radius - Rational(b.r);
    CHECK(x * x + y * y <= room * room);
    solids += 4.0 / 3 * b.r * b.r * b.r;
  }
  const double height = std::strtod(start.text(start.box()[2]).c_str(), nullptr);
  CHECK(height * 0.01 * 0.01 / solids - 1 ==
        Approx(start.void_ratio().first.convert_to<double>()).epsilon(1e-7));
}

TEST_CASE("placement: a periodic deposit does not overlap with its images") {
  const ParticleSet set = set_of(narrow, 500);
  const Placement start(set, Footprint{ratio(15, 1000), ratio(2, 100), std::nullopt, Sides::periodic}, 1,
                        Start::deposit);
  std::vector<Ball> balls = read_balls(written(write_xyzr, start));
  const std::size_t n = balls.size();
  const double a = std::strtod(start.text(start.box()[0]).c_str(), nullptr),
               b = std::strtod(start.text(start.box()[1]).c_str(), nullptr);
  for (const auto &[x, y] : {std::pair(a, 0.0), {0.0, b}, {a, b}, {a, -b}})
    for (std::size_t i = 0; i < n; ++i)
      balls.push_back({{balls[i].x[0] + x, balls[i].x[1] + y, balls[i].x[2]}, balls[i].r});
  CHECK(by_cells(balls) == 0);
  CHECK(std::any_of(balls.begin(), balls.begin() + static_cast<std::ptrdiff_t>(n),
                    [](const Ball &ball) { return ball.x[0] < ball.r; }));
}

TEST_CASE("placement: what cannot be deposited is refused before the work") {
  const ParticleSet set = set_of(sand);
  CHECK(
      contains(refusal_of(set, Footprint{ratio(1, 1000), 1, std::nullopt}, Start::deposit), "--box of 0.00"));
  CHECK(contains(refusal_of(set_of(narrow, Integer(20000000)), std::nullopt, Start::deposit), "10000000"));
  CHECK(contains(refusal_of(set, Footprint{10000000, 1, std::nullopt}, Start::deposit), "--start layers"));
  CHECK(contains(refusal_of(set, Footprint{ratio(4, 1000), ratio(4, 1000), ratio(1, 1000)}, Start::deposit),
                 "leave the height of --box out"));
}

TEST_CASE("placement: the seed and nothing else chooses the places") {
  const ParticleSet set = set_of(narrow);
  const auto text = [&set](std::uint64_t seed) {
    return written(write_lammps_data, Placement(set, std::nullopt, seed));
  };
  CHECK(text(1) == text(1));
  CHECK(text(1) != text(2));
  const auto deposited = [&set](std::uint64_t seed) {
    return written(write_lammps_data, Placement(set, std::nullopt, seed, Start::deposit));
  };
  CHECK(deposited(1) == deposited(1));
  CHECK(deposited(1) != deposited(2));
}

TEST_CASE("placement: the largest class is at the bottom") {
  const ParticleSet set = set_of(sand);
  double z = 0, r = 1;
  for (const Ball &b : read_balls(written(write_xyzr, Placement(set, std::nullopt, 1)))) {
    CHECK(b.r <= r);
    if (b.r < r)
      CHECK(b.x[2] > z);
    z = b.r < r ? b.x[2] : std::max(z, b.x[2]);
    r = b.r;
  }
}

TEST_CASE("placement: the void ratio is that of the box") {
  const ParticleSet set = set_of(sand);
  const Placement start(set, Footprint{ratio(1, 100), ratio(1, 100), ratio(1, 10)}, 1);
  CHECK(start.text(start.box()[2]) == "0.1");
  double solids = 0;
  for (const Ball &b : read_balls(written(write_xyzr, start)))
    solids += 4.0 / 3 * std::acos(-1.0) * b.r * b.r * b.r;
  const auto [lo, hi] = start.void_ratio();
  CHECK(lo < hi);
  CHECK(1e-5 / solids - 1 == Approx(lo.convert_to<double>()).epsilon(1e-7));
}

TEST_CASE("placement: the void ratio is between those of rounded diameters and of rounded radii") {
  const ParticleSet set =
      particle_set(solve(read_gradation(sand, "sand.csv")), {SizeUnit::m, 2650, ratio(1, 100)});
  const Placement start(set, std::nullopt, 1);
  double box = 1;
  for (const std::int64_t side : start.box())
    box *= std::stod(start.text(side));
  const auto [lo, hi] = start.void_ratio();
  double by_radii = 0, by_diameters = 0;
  for (const Ball &b : read_balls(written(write_xyzr, start)))
    by_radii += 4.0 / 3 * std::acos(-1.0) * b.r * b.r * b.r;
  for (const ParticleClass &c : set.classes)
    by_diameters +=
        c.quantity().convert_to<double>() * std::acos(-1.0) / 6 * std::pow(c.sizes[0].diameter.value, 3);
  std::vector<double> ratios = {box / by_radii - 1, box / by_diameters - 1};
  std::sort(ratios.begin(), ratios.end());
  CHECK(ratios[1] > 1.001 * ratios[0]);
  CHECK(lo.convert_to<double>() == Approx(ratios[0]).epsilon(1e-12));
  CHECK(hi.convert_to<double>() == Approx(ratios[1]).epsilon(1e-12));
}

TEST_CASE("placement: what cannot be placed is refused") {
  const ParticleSet set = set_of(sand);
  CHECK(
      contains(refusal_of(set, Footprint{ratio(85, 100000), 1, std::nullopt}), "narrower than the largest"));
  CHECK(contains(refusal_of(set, Footprint{ratio(1, 1000), ratio(1, 1000), ratio(5, 1000)}), "is 0.0"));
  CHECK(contains(refusal_of(set, Footprint{1000000000000, 1, std::nullopt}), "are the units right?"));
  CHECK(contains(refusal_of(set_of(narrow, Integer(3000000000)), std::nullopt), "more than the 2147483647"));
  CHECK(contains(refusal_of(set, Footprint{ratio(18, 10000), ratio(18, 10000), ratio(2, 1000)}, Start::mixed),
                 "leave the height of --box out"));
  CHECK(contains(refusal_of(set, Footprint{ratio(1, 1000), ratio(1, 1000), ratio(1, 2000)}, Start::mixed),
                 "does not fit into the box"));
  CHECK(contains(refusal_of(set_of("size_um,mass\n1e-18,1\n2e-18,0\n"), std::nullopt), "--unit"));
}

TEST_CASE("placement: sizes a million times apart") {
  const ParticleSet set = set_of("size_um,mass\n1,0.000000000000000001\n2,0\n1000000,1\n2000000,0\n", 50);
  const Placement start(set, std::nullopt, 1);
  const std::vector<Ball> balls = read_balls(written(write_xyzr, start));
  CHECK(Integer(balls.size()) == set.particles());
  CHECK(all_pairs(balls) == 0);
  CHECK(outside(balls, start) == 0);
}

TEST_CASE("placement: the square in a circle") {
  const Footprint square = inscribed_square(50);
  CHECK(square.a == square.b);
  CHECK(square.a * square.a <= 1250);
  CHECK((square.a + ratio(1, power_of_ten(12))) * (square.a + ratio(1, power_of_ten(12))) > 1250);
}

TEST_CASE("written files: readers find each particle again") {
  for (const SizeUnit unit : {SizeUnit::m, SizeUnit::mm}) {
    const ParticleSet set = set_of(sand, 1, unit);
    const Placement start(set, std::nullopt, 1);
    std::string diameters, radii;
    for (auto c = set.classes.rbegin(); c != set.classes.rend(); ++c)
      for (Integer i = 0; i < c->quantity(); ++i) {
        diameters += (diameters.empty() ? "" : " ") + to_decimal(c->sizes[0].diameter.decimal());
        radii += (radii.empty() ? "" : " ") + to_decimal(Rational(2 * c->sizes[0].radius.decimal()));
      }
    ParticleOptions options;
    options.unit = unit; // handed on in mm
    const auto in_unit = [unit](std::string text) { return unit == SizeUnit::mm ? text : std::string(); };
    const Result lammps = read(written(write_lammps_data, start), options);
    CHECK(lammps.format == ParticleFormat::lammps_data);
    const Result yade = read(written(write_xyzr, start), options);
    CHECK(yade.format == ParticleFormat::xyzr);
    const Result vtk = read(written(write_vtk, start), options);
    CHECK(vtk.format == ParticleFormat::vtk);
    const Result list = read(written(write_diameters, set), options);
    CHECK(list.format == ParticleFormat::diameters);
    CHECK(yade.particles == vtk.particles);
    CHECK(lammps.particles == list.particles);
    if (unit == SizeUnit::mm) {
      CHECK(lammps.particles == in_unit(diameters));
      CHECK(yade.particles == in_unit(radii));
    }
    CHECK(read(written(write_size_csv, set)).format == ParticleFormat::csv);
  }
}

TEST_CASE("written files: LIGGGHTS's insertions have distinct primes and running totals") {
  const std::string text = written(write_liggghts, set_of(sand));
  std::istringstream words(text);
  std::map<std::string, int> seeds;
  std::string totals;
  for (std::string word, before; words >> word; before = word) {
    if (before == "particletemplate/sphere" || before == "discrete/numberbased" || before == "seed" ||
        before == "particledistribution/discrete/numberbased")
      ++seeds[word];
    if (before == "particles_in_region")
      totals += word + " ";
  }
  CHECK(totals == "1 3 28 296 576 666 1485 ");
  CHECK(seeds.size() == 21);
  for (const auto &[seed, times] : seeds) {
    CHECK(times == 1);
    const int n = std::stoi(seed);
    CHECK(n > 10000);
    for (int d = 2; d * d <= n; ++d)
      CHECK(n % d != 0);
  }
}

TEST_CASE("written files: MercuryDPM's distribution goes from 0 to 1 with each radius twice") {
  std::istringstream lines(written(write_mercurydpm, set_of(narrow)));
  std::string line;
  REQUIRE(std::getline(lines, line));
  CHECK(contains(line, "counts are not exact"));
  std::vector<std::pair<double, double>> rows;
  while (std::getline(lines, line)) {
    char *rest = nullptr;
    const double radius = std::strtod(line.c_str(), &rest);
    rows.emplace_back(radius, std::strtod(rest + 1, nullptr));
  }
  REQUIRE(rows.size() == 6);
  CHECK(rows.front().second == 0);
  CHECK(rows.back().second == 1);
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    CHECK(rows[i].first == rows[i + 1].first);
    CHECK(rows[i].second < rows[i + 1].second);
  }
}

TEST_CASE("written files: a name in any script stays a name and VTK's title is short") {
  const std::string name = "a\"b$c&d\\e\n\xC3\xA9" + std::string(400, 'x');
  ParticleSet set = set_of(narrow);
  set.name = name;
  const std::string vtk = written(write_vtk, Placement(set, std::nullopt, 1));
  const std::size_t begin = vtk.find('\n') + 1, end = vtk.find('\n', begin);
  CHECK(end - begin < 256);
  CHECK(contains(vtk.substr(begin, end - begin), "The mass of each class"));
  CHECK(is_utf8(vtk));
  CHECK(read(vtk).format == ParticleFormat::vtk);
  const std::string liggghts = written(write_liggghts, set);
  CHECK(liggghts.substr(0, liggghts.find('\n')).find_first_of("\"$&\\") == std::string::npos);
}

TEST_CASE("written files: LIGGGHTS's insertions and MercuryDPM's steps are read with their counts") {
  const ParticleSet set = set_of("size_mm,mass\n1,10\n1.4,0\n2,50\n2.8,40\n4,0\n", 1, SizeUnit::mm);
  std::string ascending, descending;
  for (const ParticleClass &c : set.classes) {
    std::string one = to_decimal(Rational(2 * c.sizes[0].radius.decimal()));
    if (c.quantity() != 1)
      one += "*" + to_string(c.quantity());
    ascending += (ascending.empty() ? "" : " ") + one;
    descending = one + (descending.empty() ? "" : " ") + descending;
  }
  const Result mercury = read(written(write_mercurydpm, set));
  CHECK(mercury.format == ParticleFormat::mercurydpm);
  CHECK(mercury.particles == ascending);
  ParticleOptions in_mm;
  in_mm.unit = SizeUnit::mm;
  const Result liggghts = read(written(write_liggghts, set), in_mm);
  CHECK(liggghts.format == ParticleFormat::liggghts_insertion);
  CHECK(liggghts.particles == descending);
}

TEST_CASE("LIGGGHTS insertions: what draws at random, or is not there, is refused") {
  const ParticleOptions options = from(ParticleFormat::liggghts_insertion);
  const std::string t = "fix t all particletemplate/sphere 10007 radius constant 1\n";
  const std::string d = "fix d all particledistribution/discrete/numberbased 10009 1 t 1\n";
  const std::string i = "fix i all insert/pack distributiontemplate d particles_in_region ";
  CHECK(read(t + d + i + "3\n", options).particles == "2000*3");
  CHECK(read(t + d + i + "3\n" + i + "5\n", options).particles == "2000*3 2000*2");
  CHECK(contains(refusal(t + d + i + "3\n" + i + "3\n", options), "file:4: particles_in_region"));
  CHECK(contains(refusal(t + d + i + "x\n", options), "running total"));
  CHECK(contains(refusal(d + i + "3\n", options), "file:1: the distribution has no template"));
  CHECK(contains(refusal(t + i + "3\n", options), "file:2: the insertion has no distributiontemplate"));
  CHECK(contains(refusal(t + d, options), "no particles"));
  CHECK(
      contains(refusal(t + "fix d all particledistribution/discrete/numberbased 10009 2 t 1 t 1\n", options),
               "at random"));
  CHECK(
      contains(refusal(t + "fix d all particledistribution/discrete 10009 1 t 1\n", options), "numberbased"));
  CHECK(contains(refusal("fix t all particletemplate/sphere 10007 radius gaussian number 1 2\n", options),
                 "constant"));
  CHECK(contains(refusal("fix t all particletemplate/sphere 10007 radius constant\n", options), "constant"));
}

TEST_CASE("MercuryDPM: broken distributions are refused") {
  const ParticleOptions options = from(ParticleFormat::mercurydpm);
  const std::string good = "radius_mm,cumulative_number,4 particles: a\n1,0\n1,0.25\n2,0.25\n2,1\n";
  CHECK(read(good, options).particles == "2 4*3");
  check_truncations(good, options);
  const auto changed = [&good](const std::string &part, const std::string &by) {
    std::string text = good;
    return text.replace(text.find(part), part.size(), by);
  };
  CHECK(contains(refusal(changed("4 particles", "particles"), options), "file:1: the heading"));
  CHECK(contains(refusal(changed("_mm", "_ft"), options), "file:1: the heading"));
  CHECK(contains(refusal(changed("1,0.25", "1,0.3"), options), "file:3: the step is not"));
  CHECK(contains(refusal(changed("2,0.25", "2,0.5"), options), "file:4: the step does not begin"));
  CHECK(contains(refusal(changed("2,1", "3,1"), options), "file:5: the step has two radii"));
  CHECK(contains(refusal(changed("2,1", "2 1"), options), "file:5: the row"));
  CHECK(contains(refusal(changed("2,1", "2,x"), options), "file:5: cumulative"));
  CHECK(
      contains(refusal(changed("1,0\n", "0,0\n").replace(good.find("1,0.25"), 1, "0"), options), "above 0"));
}

TEST_CASE("placement: particles of many sizes in a class") {
  Question question;
  question.at_least = 5000;
  const Match m = solve(read_gradation(narrow, "sand.csv"), question);
  const ParticleSet set = spread_particle_set(m, 1);
  const Placement start(set, Footprint{ratio(3, 100), ratio(2, 100), std::nullopt}, 1);
  const std::vector<Ball> balls = read_balls(written(write_xyzr, start));
  CHECK(Integer(balls.size()) == m.particles());
  CHECK(all_pairs(balls) == 0);
  CHECK(outside(balls, start) == 0);
}

} // namespace placement_test
