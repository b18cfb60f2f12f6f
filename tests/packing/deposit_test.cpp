#include "packing/support.hpp"

#include <algorithm>

namespace deposit_test {

using namespace mdm;
using namespace packing_test;

namespace {

DepositOptions options(DepositRule rule, FloorRule floor, bool periodic) {
  DepositOptions o;
  o.rule = rule;
  o.floor = floor;
  o.periodic = periodic;
  return o;
}

/// How a deposit can be made, in all ways.
std::vector<DepositOptions> all_options() {
  std::vector<DepositOptions> all;
  for (const DepositRule rule : {DepositRule::lowest, DepositRule::drop})
    for (const FloorRule floor : {FloorRule::left, FloorRule::centred})
      for (const bool periodic : {true, false})
        all.push_back(options(rule, floor, periodic));
  return all;
}

} // namespace

TEST_CASE("discs of a deposit do not overlap and rest on two supports, as another program finds") {
  Judge judge;
  for (const std::uint64_t ratio : {1U, 2U, 4U, 30U})
    for (const DepositOptions &o : all_options())
      judge.add(deposit(discs(ratio == 30 ? 700 : 300, ratio), o));
  CHECK(judge.accepts());
}

TEST_CASE("the judge of packings refuses discs that overlap or roll off") {
  Packing p = deposit(discs(100, 2));
  const auto refuses = [](const Packing &changed) {
    Judge judge;
    judge.add(changed);
    return !judge.accepts();
  };
  Packing overlapping = p;
  overlapping.discs[50].r += 20;
  CHECK(refuses(overlapping));
  Packing floating = p;
  floating.discs[99].y += 1000;
  CHECK(refuses(floating));
  Packing rolling = p;
  std::swap(rolling.discs[99].left, rolling.discs[99].right);
  CHECK(refuses(rolling));
}

TEST_CASE("blocks find the places that a walk along all of the surface finds") {
  for (const std::uint64_t ratio : {1U, 2U, 5U, 40U})
    for (const FloorRule floor : {FloorRule::left, FloorRule::centred})
      for (const bool periodic : {true, false})
        for (const std::uint64_t seed : {1U, 2U}) {
          DepositOptions o = options(DepositRule::lowest, floor, periodic);
          o.seed = seed;
          const DiscSizes sizes = discs(ratio == 40 ? 1500 : 600, ratio, seed);
          const Packing by_blocks = deposit(sizes, o);
          o.search = DepositSearch::full_walk;
          CHECK(by_blocks == deposit(sizes, o));
        }
}

TEST_CASE("a packing is the same with every compiler") {
  // FNV-1a of the packing files; equal with g++ and clang, without optimisation and with it.
  const auto hash = [](const Packing &p) {
    std::uint64_t h = 0xcbf29ce484222325;
    for (const char c : file_text(p))
      h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return h;
  };
  const DiscSizes sizes = discs(2000, 4);
  CHECK(hash(deposit(sizes)) == 5367183917701588743U);
  CHECK(hash(deposit(sizes, options(DepositRule::drop, FloorRule::left, false))) == 18102440761380476669U);
}

TEST_CASE("each disc keeps its size, rounded up to the lattice, in the order that was asked for") {
  const DiscSizes sizes = discs(200, 3);
  DepositOptions o;
  o.shuffled = false;
  const Packing p = deposit(sizes, o);
  for (std::size_t i = 0; i < sizes.sizes.size(); ++i)
    CHECK(p.discs[i].r == DiscSizes::radius(sizes.sizes[i], p.places));
  o.shuffled = true;
  const Packing shuffled = deposit(sizes, o);
  CHECK(shuffled.radii_hash() == p.radii_hash());
  CHECK(shuffled.discs != p.discs);
  o.seed = 2;
  CHECK(deposit(sizes, o).discs != shuffled.discs);
}

TEST_CASE("equal discs from the left make a triangular lattice") {
  DiscSizes sizes;
  sizes.sizes.assign(200, {1, 0});
  DepositOptions o = options(DepositRule::lowest, FloorRule::left, true);
  o.width = Rational(10);
  const Packing p = deposit(sizes, o);
  // Gaps of some units leave room for nine discs in a row and a part of one.
  const auto row = [&p](std::size_t i) { return p.discs[i].y; };
  CHECK(row(8) == row(0));
  CHECK(row(10) > row(0));
  CHECK(p.discs.back().y < 22 * p.width / 10);
}

TEST_CASE("what cannot be packed is refused before the work") {
  CHECK(has(refusal([&] { deposit(DiscSizes{}); }), "no disc"));
  DepositOptions o;
  o.width = Rational(299) / 100;
  DiscSizes sizes;
  sizes.sizes.assign(10, {1, 0});
  CHECK(has(refusal([&] { deposit(sizes, o); }), "--width"));
  CHECK(has(refusal([&] { deposit(sizes, o); }), "3 wide"));
  o.width = Rational(3);
  CHECK(deposit(sizes, o).discs.size() == 10);
  o.width.reset();
  sizes.sizes.resize(3);
  CHECK(has(refusal([&] { deposit(sizes, o); }), "too few"));
  o.width = Rational(1000000000000);
  CHECK(has(refusal([&] { deposit(sizes, o); }), "lattice"));
}

TEST_CASE("narrow boxes hold discs that are their own neighbours on both sides") {
  Judge judge;
  DepositOptions o;
  o.width = Rational(3);
  DiscSizes sizes;
  for (std::uint64_t i = 0; i < 100; ++i)
    sizes.sizes.push_back({70 + i * 37 % 31, 2});
  for (const bool periodic : {true, false}) {
    o.periodic = periodic;
    judge.add(deposit(sizes, o));
  }
  CHECK(judge.accepts());
}

} // namespace deposit_test
