// A trade-off read back from its JSON.

#include "catch.hpp"
#include "report/tradeoff_reader.hpp"
#include "report/tradeoff_report.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

namespace tradeoff_reader_test {

using namespace mdm;

namespace {

Tradeoff of_sand() {
  TradeoffOptions options;
  options.tolerances = {0, ratio(1, 2), 5};
  Question question;
  question.min_per_class = 2;
  return tradeoff(read_gradation("size_um,passing_percent\n75,3\n250,30\n1180,70\n4750,100\n", "sand.csv"),
                  question, options);
}

void check_rows(const std::vector<TradeoffRow> &read, const std::vector<TradeoffRow> &written) {
  REQUIRE(read.size() == written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i].tolerance == written[i].tolerance);
    CHECK(compare(read[i].smallest, written[i].smallest) == 0);
    CHECK(read[i].lost == written[i].lost);
    CHECK(read[i].particles == written[i].particles);
    CHECK(read[i].lower_bound == written[i].lower_bound);
    CHECK(read[i].has_none == written[i].has_none);
  }
}

const std::string row = R"({"tolerance":"0","smallest":"0.5","lost":"1/3","status":"feasible",)"
                        R"("particles":"7","lower_bound":"5"})";

/// A trade-off of one row a curve, with a part of it replaced.
std::string text(const std::string &part = "", const std::string &other = "") {
  std::string json = R"({"schema":"mdm-tradeoff-1","id":"sand","question":"","unit":"mm","kind":"total",)"
                     R"("by_tolerance":[)" +
                     row + R"(],"by_sieve":[)" + row + R"(],"notes":["a note"],"versions":{"mdm":"1"}})";
  if (!part.empty()) {
    REQUIRE(json.find(part) != std::string::npos);
    json.replace(json.find(part), part.size(), other);
  }
  return json;
}

} // namespace

TEST_CASE("a trade-off that was written is read as it was") {
  const Tradeoff t = of_sand();
  const std::string json = tradeoff_json(t);
  CHECK(is_tradeoff(json));
  const StatedTradeoff read = read_tradeoff(json, "t.json");
  CHECK(read.id == t.gradation.id());
  CHECK(read.question == in_words(t.question, t.gradation.unit()));
  CHECK(read.unit == SizeUnit::um);
  CHECK(read.kind == AskedTolerance::Kind::retained);
  CHECK(read.notes == t.gradation.notes());
  check_rows(read.by_tolerance, t.by_tolerance);
  check_rows(read.by_sieve, t.by_sieve);
}

TEST_CASE("a trade-off by hand is read exactly") {
  const StatedTradeoff t = read_tradeoff(text(), "t.json");
  CHECK(t.kind == AskedTolerance::Kind::total);
  REQUIRE(t.by_sieve.size() == 1);
  CHECK(t.by_sieve[0].lost == ratio(1, 3));
  CHECK(t.by_sieve[0].particles == Integer(7));
  CHECK_FALSE(t.by_sieve[0].is_optimal());
  CHECK_FALSE(read_tradeoff(text(R"("7")", "null"), "t.json").by_tolerance[0].particles);
}

TEST_CASE("what is no trade-off is refused, with its place") {
  CHECK_FALSE(is_tradeoff("size_mm,mass\n1,2\n"));
  CHECK_FALSE(is_tradeoff(R"({"schema":"mdm-answer-1"})"));
  const auto check = [](const std::string &part, const std::string &other, const std::string &message) {
    CHECK_THROWS_WITH(read_tradeoff(text(part, other), "t.json"),
                      Catch::StartsWith("t.json") && Catch::Contains(message));
  };
  check("mdm-tradeoff-1", "mdm-answer-1", "schema");
  check(R"("unit":"mm")", R"("unit":"ell")", "unit: 'ell'");
  check(R"("total")", R"("rounding")", "kind: 'rounding'");
  check(R"("1/3")", R"("4/3")", "by_tolerance[0]: lost");
  check(R"("1/3")", R"("1/0")", "by_tolerance[0]: lost");
  check(R"("7")", R"("4")", "less than lower_bound");
  check(R"("7")", R"("-7")", "particles");
  check(R"("7")", "{}", "particles");
  check(R"("tolerance":"0")", R"("tolerance":"-1")", "tolerance is below 0");
  check("[" + row + "]", "[]", "by_tolerance");
  check(R"(["a note"])", "[1e5, {}]", "notes");
  check(R"("id":"sand",)", "", "id is missing");
  check(R"("versions")", R"(versions)", "t.json:1");
}

} // namespace tradeoff_reader_test
