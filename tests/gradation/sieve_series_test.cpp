#include "gradation/sieve_series.hpp"
#include "support.hpp"

#include <algorithm>

namespace sieve_series_test {

using namespace mdm;
using namespace mdm::test;

namespace {

/// The openings in mm, as a text.
std::string openings(const std::string &series, std::size_t first, std::size_t count) {
  const std::vector<Rational> all = sieve_series(series);
  std::string text;
  for (std::size_t i = first; i < std::min(all.size(), first + count); ++i)
    text += (text.empty() ? "" : " ") + to_decimal(all[i]);
  return text;
}

} // namespace

TEST_CASE("the principal sizes of ISO 3310-1 are each third of R20") {
  CHECK(
      openings("ISO R20/3", 0, 99) ==
      "0.022 0.032 0.045 0.063 0.09 0.125 0.18 0.25 0.355 0.5 0.71 1 1.4 2 2.8 4 5.6 8 11.2 16 22.4 31.5 45 "
      "63 90 125");
}

TEST_CASE("R20 has twenty sizes a decade, of two digits below 40 um") {
  CHECK(openings("ISO R20", 0, 8) == "0.02 0.022 0.025 0.028 0.032 0.036 0.04 0.045");
  CHECK(openings("ISO R20", 34, 5) == "1 1.12 1.25 1.4 1.6");
  CHECK(sieve_series("ISO R20").size() == 77);
}

TEST_CASE("series of names have the openings of the names") {
  CHECK(openings("ASTM E11", 0, 5) == "0.02 0.025 0.032 0.038 0.045");
  CHECK(sieve_series("ASTM E11").back() == 125);
  CHECK(openings("Tyler", 0, 3) == "0.038 0.045 0.053");
}

TEST_CASE("phi series are powers of two, and their roots to 15 digits") {
  CHECK(openings("phi", 0, 2) == "0.00006103515625 0.0001220703125");
  CHECK(sieve_series("phi").back() == 128);
  CHECK(openings("half-phi", 28, 3) == "1 1.4142135623731 2");
  CHECK(sieve_series("quarter-phi").size() == 85);
}

TEST_CASE("series ascend") {
  for (const std::string name :
       {"ISO R20/3", "ISO R20", "ASTM E11", "Tyler", "phi", "half-phi", "quarter-phi"}) {
    const std::vector<Rational> all = sieve_series(name);
    CHECK(std::is_sorted(all.begin(), all.end()));
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
  }
}

TEST_CASE("other series are refused") {
  CHECK(message_of([] { sieve_series("ISO"); }).find("'ISO' is no series of sieves: write ISO R20/3") == 0);
  CHECK(message_of([] { sieve_series(""); }).find("'' is no series") == 0);
}

} // namespace sieve_series_test
