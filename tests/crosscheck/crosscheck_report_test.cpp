// Rows and summaries as other programs read them.

#include "catch.hpp"
#include "crosscheck/crosscheck_report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace crosscheck_report_test {

using namespace mdm;
using Json = nlohmann::json;

namespace {

CrosscheckRow row(AnswerVerdict verdict, int n, int least, const std::string &setting = "") {
  CrosscheckRow r;
  r.id = "a";
  r.setting = setting;
  r.verdict = verdict;
  r.particles = n;
  r.minimum = least;
  if (verdict == AnswerVerdict::minimal || verdict == AnswerVerdict::larger)
    r.ratio = ratio(n, least);
  return r;
}

std::string row_json(const CrosscheckRow &r, bool has_setting) {
  JsonWriter json;
  write_row(json, r, has_setting);
  return json.take();
}

std::string summary_json(const CrosscheckSummary &summary, bool has_setting) {
  JsonWriter json;
  summary.write(json, has_setting);
  return json.take();
}

} // namespace

TEST_CASE("CSV rows have the columns of the contract, others only behind them", "[study]") {
  CHECK(crosscheck_csv_header({}) == "id,verdict,particles,minimum,ratio,max_error\n");
  CHECK(crosscheck_csv_header({"knob", true}) ==
        "id,verdict,particles,minimum,ratio,max_error,knob,reason\n");
  CrosscheckRow r = row(AnswerVerdict::larger, 20, 3, "0.5");
  r.max_error = ratio(1, 300);
  CHECK(crosscheck_csv(r, {}) == "a,larger,20,3,6.66666,0.333333\n");
  CHECK(crosscheck_csv(r, {"knob", false}) == "a,larger,20,3,6.66666,0.333333,0.5\n");
  CrosscheckRow none;
  none.id = "a,\"b\"\n";
  none.reason = "x, y";
  CHECK(crosscheck_csv(none, {"", true}) == "\"a,\"\"b\"\"\\x0a\",no-answer,,,,,\"x, y\"\n");
}

TEST_CASE("JSON rows have every exact number as a string, and null for what is not known", "[study]") {
  CrosscheckRow r = row(AnswerVerdict::minimal, 3, 3, "s");
  r.max_error = 0;
  const Json full = Json::parse(row_json(r, true));
  CHECK(full == Json::parse(R"({"id":"a","setting":"s","verdict":"minimal","particles":"3","minimum":"3",)"
                            R"("ratio":"1","max_error":"0","reason":null})"));
  CrosscheckRow none;
  none.reason = "r";
  CHECK(Json::parse(row_json(none, false)) ==
        Json::parse(R"({"id":"","verdict":"no-answer","particles":null,"minimum":null,"ratio":null,)"
                    R"("max_error":null,"reason":"r"})"));
}

TEST_CASE("quartiles are order statistics", "[study]") {
  CHECK(!quartiles({}));
  CHECK(quartiles({Rational(7)}) == Quartiles{7, 7, 7, 7, 7});
  CHECK(quartiles({2, 1}) == Quartiles{1, 1, 2, 2, 2});
  CHECK(quartiles({4, 3, 2, 1}) == Quartiles{1, 2, 3, 4, 4});
  CHECK(quartiles({5, 4, 3, 2, 1}) == Quartiles{1, 2, 3, 4, 5});
}

TEST_CASE("a summary counts verdicts by setting and shows what is no match", "[study]") {
  CrosscheckSummary summary;
  summary.add(row(AnswerVerdict::larger, 3, 2, "b"));
  summary.add(row(AnswerVerdict::minimal, 2, 2, "a"));
  summary.add(row(AnswerVerdict::minimal, 2, 2, "b"));
  summary.add(row(AnswerVerdict::crashed, 2, 2, "a"));
  REQUIRE(summary.settings().size() == 2);
  CHECK(summary.settings()[0].name == "b");
  CHECK(summary.settings()[0].rows() == 2);
  CHECK(summary.settings()[0].count(AnswerVerdict::larger) == 1);
  CHECK(summary.count(AnswerVerdict::minimal) == 2);
  CHECK(summary.count(AnswerVerdict::timeout) == 0);
  const std::string text = summary.text({"knob", false});
  INFO(text);
  CHECK(text.find("knob") != std::string::npos);
  CHECK(text.find("crashed") != std::string::npos);
  CHECK(text.find("timeout") == std::string::npos);
  CHECK(text.find("not judged a match:\n  a (a): crashed\n") != std::string::npos);
  const Json json = Json::parse(summary_json(summary, true));
  REQUIRE(json.size() == 2);
  CHECK(json[0].at("setting") == "b");
  CHECK(json[0].at("answers") == "2");
  CHECK(json[0].at("verdicts").at("larger") == "1");
  CHECK(json[0].at("verdicts").size() == answer_verdict_count);
  CHECK(json[0].at("ratio").at("largest") == "1.5");
  CrosscheckSummary empty;
  CHECK(summary_json(empty, false) == "[]");
  empty.add(CrosscheckRow{});
  CHECK(Json::parse(summary_json(empty, false))[0].at("ratio").is_null());
}

TEST_CASE("a summary shows ten rows at most", "[study]") {
  CrosscheckSummary summary;
  for (int i = 0; i < 25; ++i)
    summary.add(row(AnswerVerdict::garbage, 1, 1));
  const std::string text = summary.text({});
  CHECK(text.find("the first 10 of 25") != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') == 14);
}

} // namespace crosscheck_report_test
