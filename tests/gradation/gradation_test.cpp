#include "support.hpp"

namespace gradation_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Gradation::Data data() {
  Gradation::Data d;
  d.sizes = {0, 1, 2, 4};
  d.masses = {1, 0, 3, 0};
  d.factors = {1, 2, 3, 4};
  d.tolerances = {0, 0, 1, 2};
  return d;
}

template <typename Change>
std::string refusal_after(Change change) {
  Gradation::Data d = data();
  change(d);
  return message_of([&d] { Gradation g(d); });
}

} // namespace

TEST_CASE("Gradation: classes lie between neighbouring sizes") {
  const Gradation g(data());
  CHECK_NOTHROW(g.check_invariant());
  CHECK(g.classes() == 3);
  CHECK(g.lower(2) == 2);
  CHECK(g.upper(2) == 4);
  CHECK(g.mass(2) == 3);
  CHECK(g.factor(2) == 3);
}

TEST_CASE("Gradation: invariants are checked") {
  using Data = Gradation::Data;
  CHECK(refusal_after([](Data &d) { d.sizes = {1}; }) == "a gradation needs at least two sizes, there are 1");
  CHECK(contains(refusal_after([](Data &d) { d.masses.pop_back(); }), "must be as many as the sizes"));
  CHECK(contains(refusal_after([](Data &d) { d.factors.pop_back(); }), "must be as many as the sizes"));
  CHECK(contains(refusal_after([](Data &d) { d.tolerances.pop_back(); }), "must be as many as the sizes"));
  CHECK(contains(refusal_after([](Data &d) { d.unit = SizeUnit::in; }), "kept in mm, um or m"));
  CHECK(refusal_after([](Data &d) { d.sizes[0] = -1; }) == "size -1 mm is negative");
  CHECK(refusal_after([](Data &d) { d.sizes[2] = 1; }) == "size 1 mm does not ascend");
  CHECK(refusal_after([](Data &d) { d.masses[1] = ratio(-1, 2); }) == "mass -0.5 is negative");
  CHECK(contains(refusal_after([](Data &d) { d.masses[3] = 5; }),
                 "the largest sieve, 4 mm, retains 5: add a larger sieve"));
  CHECK(contains(refusal_after([](Data &d) { d.masses = {0, 0, 0, 0}; }), "no sieve retains anything"));
  CHECK(refusal_after([](Data &d) { d.factors[3] = 0; }) == "a factor must be above 0");
  CHECK(refusal_after([](Data &d) { d.tolerances[0] = -1; }) == "a tolerance must not be negative");
}

TEST_CASE("Gradation: the pan takes a size") {
  const Gradation g = Gradation(data()).with_pan_size(ratio(1, 2));
  CHECK(text(g.sizes()) == "0.5 1 2 4");
  CHECK(contains(message_of([&g] { g.with_pan_size(ratio(1, 4)); }), "there is no pan to give a size to"));
  for (const int size : {-1, 0, 1, 2})
    CHECK(contains(message_of([size] { Gradation(data()).with_pan_size(size); }),
                   "must lie between 0 and the finest sieve, 1 mm"));
}

TEST_CASE("Gradation: a cut drops classes with all their columns") {
  const Gradation g = Gradation(data()).cut_below(1);
  CHECK(text(g.sizes()) == "1 2 4");
  CHECK(text(g.masses()) == "0 3 0");
  CHECK(text(g.tolerances()) == "0 1 2");
  CHECK(g.factor(0) == 2);
  CHECK(text(Gradation(data()).cut_below(0).sizes()) == "0 1 2 4");
  CHECK(contains(message_of([] { Gradation(data()).cut_below(3); }), "there is no sieve of 3 mm to cut at"));
  CHECK(contains(message_of([] { Gradation(data()).cut_below(4); }), "leaves nothing"));
  Gradation::Data fine = data();
  fine.masses = {1, 0, 0, 0};
  CHECK(contains(message_of([&fine] { Gradation(fine).cut_below(1); }), "cutting at 1 mm leaves no mass"));
}

TEST_CASE("Gradation: sizes scale") {
  CHECK(text(Gradation(data()).scaled(ratio(5, 2)).sizes()) == "0 2.5 5 10");
  CHECK(contains(message_of([] { Gradation(data()).scaled(0); }), "size factor 0 must be above 0"));
}

TEST_CASE("a gradation is made from sizes and masses in one call") {
  const Gradation g({1, ratio(3, 2), 4}, {2, 1, 0}, SizeUnit::um, "sand");
  CHECK(g.sizes() == std::vector<Rational>{1, ratio(3, 2), 4});
  CHECK(g.masses() == std::vector<Rational>{2, 1, 0});
  CHECK(g.unit() == SizeUnit::um);
  CHECK(g.id() == "sand");
  CHECK_THROWS_AS(Gradation({1, 2}, {1, 1}), InputError);
  CHECK_THROWS_AS(Gradation({1, 2}, {1}), InputError);
}

TEST_CASE("a gradation is made from decimals in one call, exactly") {
  const Gradation g = gradation_of({"0.075", "0.15", "3e-1"}, {"3.6", "9", "0"});
  CHECK(g.sizes() == std::vector<Rational>{ratio(75, 1000), ratio(15, 100), ratio(3, 10)});
  CHECK(g.mass(0) == ratio(36, 10));
  CHECK_THROWS_WITH(gradation_of({"0.1", "a"}, {"1", "0"}), Catch::StartsWith("size 2: "));
  CHECK_THROWS_WITH(gradation_of({"0.1", "1"}, {"", "0"}), Catch::StartsWith("mass 1: "));
}

TEST_CASE("a gradation is read from a path in one call, and what is wrong names the file") {
  const std::string folder = MDM_SOURCE_DIR "/examples/gradations/";
  const Gradation g = read_gradation_file(folder + "athabasca-sand.csv");
  CHECK(g.id() == "athabasca-sand");
  CHECK(g.classes() == 7);
  CHECK_THROWS_WITH(read_gradation_file(folder + "none.csv"),
                    Catch::StartsWith(folder + "none.csv: cannot be read: "));
  CHECK_THROWS_WITH(read_gradation_file(folder), Catch::StartsWith(folder + ": cannot be read: "));
  CHECK_THROWS_WITH(read_gradation_file(MDM_SOURCE_DIR "/README.md"), Catch::Contains("/README.md:"));
}

} // namespace gradation_test
