// mdm-totals-1: what is written is read, and nothing else is.

#include "answer/totals.hpp"
#include "catch.hpp"

#include <mdm/text/error.hpp>

namespace totals_test {

using namespace mdm;

namespace {

Totals some_totals() {
  Totals t;
  t.shard = 7;
  t.shards = 100;
  t.question = "--tolerance retained:1%";
  t.suite = SuiteTotals{{12, std::string(64, 'a')}, LineSum::parse(std::string(64, 'e')).value()};
  t.sum = LineSum::parse(std::string(64, 'f')).value();
  t.lines = 18446744073709551615u;
  t.errors = 3;
  t.exit = 2;
  t.answers = {{34, std::string(64, 'b')}, "7 \"x\".jsonl"};
  t.versions = {{"mdm", "0.1.0"}, {"gmp", "6"}};
  return t;
}

std::string replaced(std::string text, const std::string &from, const std::string &to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

std::string refusal(const std::string &text) {
  try {
    read_totals(text, "a.totals");
  } catch (const InputError &e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST_CASE("totals are read as they were written", "[answer]") {
  Totals t = some_totals();
  const Totals alone = read_totals(totals_json(t), "");
  CHECK(totals_json(alone) == totals_json(t));
  CHECK(alone.lines == t.lines);
  CHECK(alone.answers.name == t.answers.name);
  CHECK(alone.suite == t.suite);
  CHECK_FALSE(alone.proofs);
  t.suite.reset();
  t.made = MadeSuite{std::string(64, '1'), 7, 1, 1000};
  t.alone = FileTotals{90, std::string(64, '2')};
  t.proofs = {{56, std::string(64, 'c')}, "7.proofs"};
  t.index = {{78, std::string(64, 'd')}, "7.proofs.index"};
  const Totals with_proofs = read_totals(totals_json(t), "");
  CHECK(totals_json(with_proofs) == totals_json(t));
  CHECK(with_proofs.index->bytes == 78);
  CHECK_FALSE(with_proofs.suite);
  CHECK(with_proofs.made == t.made);
  CHECK(with_proofs.alone == t.alone);
  CHECK(with_proofs.sum == t.sum);
}

TEST_CASE("what is no totals is refused", "[answer]") {
  const std::string good = totals_json(some_totals());
  for (const auto &[from, to] : std::vector<std::pair<std::string, std::string>>{
           {"mdm-totals-1", "mdm-answer-1"},
           {"\"7\"", "\"0\""},
           {"\"7\"", "\"101\""},
           {"\"7\"", "\"-7\""},
           {"\"7\"", "[]"},
           {"\"exit\":\"2\"", "\"exit\":\"4\""},
           {"\"errors\":\"3\"", "\"errors\":\"18446744073709551616\""},
           {"\"errors\":\"3\"", "\"errors\":\"\""},
           {"\"errors\"", "\"error\""},
           {"\"suite\":{", "\"suite\":[{"},
           {std::string(64, 'e'), std::string(63, 'e')},
           {std::string(64, 'f'), std::string(63, 'f') + "g"},
           {"\"answers\"", "\"proofs\""},
           {"\"versions\"", "\"version\""},
           {"\"gmp\":\"6\"", "\"gmp\":{}"},
           {"{", "{{"}})
    CHECK(refusal(replaced(good, from, to)).find("a.totals: ") == 0);
  for (const char *text : {"", "1", "[]", "null", "\xFF"})
    CHECK(refusal(text).find("a.totals: ") == 0);
  for (std::size_t i = 0; i < good.size(); ++i)
    CHECK(refusal(good.substr(0, i)) != "");
}

} // namespace totals_test
