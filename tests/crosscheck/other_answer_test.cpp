// Answers of other solvers: what is read, and what is garbage without an end of the run.

#include "catch.hpp"
#include "crosscheck/other_answer.hpp"

#include <mdm/text/error.hpp>

namespace other_answer_test {

using namespace mdm;

namespace {

std::vector<Integer> integers(std::initializer_list<int> values) {
  return {values.begin(), values.end()};
}

/// The only answer of a CSV file with that header and row.
OtherAnswer csv(const std::string &header, const std::string &row) {
  const std::vector<OtherAnswer> answers = read_answers(header + "\n" + row + "\n", "a.csv");
  REQUIRE(answers.size() == 1);
  return answers[0];
}

void check_garbage(const OtherAnswer &answer, const std::string &part) {
  INFO(answer.reason);
  CHECK(answer.failure == AnswerVerdict::garbage);
  CHECK(answer.quantities.empty());
  CHECK(answer.sizes.empty());
  CHECK(answer.reason.find(part) != std::string::npos);
}

void check_refused(const std::string &content, const std::string &part) {
  try {
    read_answers(content, "a.csv");
    FAIL("accepted");
  } catch (const InputError &e) {
    INFO(e.what());
    CHECK(std::string(e.what()).find(part) != std::string::npos);
  }
}

} // namespace

TEST_CASE("a CSV row has quantities, sizes in the unit of its column, and labels", "[study]") {
  const OtherAnswer a = csv("knob,id,sizes_um,quantities", "0.5,g1,75 150.5,15  2");
  CHECK(a.id == "g1");
  CHECK(!a.failure);
  CHECK(a.quantities == integers({15, 2}));
  REQUIRE(a.sizes.size() == 2);
  CHECK(a.sizes[1]->lo == ratio(301, 2));
  CHECK(a.sizes[1]->hi == ratio(301, 2));
  CHECK(a.unit_mm == ratio(1, 1000));
  CHECK(a.labels == std::map<std::string, std::string>{{"knob", "0.5"}});
  CHECK(csv("id,sizes_in,quantities", "a,1,1").unit_mm == ratio(254, 10));
  CHECK(csv("id,sizes_m,quantities", "a,1,1").unit_mm == 1000);
}

TEST_CASE("CSV files come with byte order mark, CRLF, comments, blank lines and quotes", "[study]") {
  const std::vector<OtherAnswer> answers = read_answers(
      "\uFEFF# answers\r\n\r\nid,quantities\r\n\"a,\"\"b\",\"1 2\"\r\n# end\r\nc,3\r\n", "a.csv");
  REQUIRE(answers.size() == 2);
  CHECK(answers[0].id == "a,\"b");
  CHECK(answers[0].quantities == integers({1, 2}));
  CHECK(answers[1].quantities == integers({3}));
  CHECK(answers[1].sizes.empty());
}

TEST_CASE("a CSV row that cannot be read is garbage with its line, and keeps its id", "[study]") {
  for (const auto &[row, part] :
       {std::pair("a,1 x", "'x'"), std::pair("a,1.5", "whole number"), std::pair("a,-1", "whole number"),
        std::pair("a,1,2", "3 fields"), std::pair("a", "1 fields"), std::pair("a,nan", "'nan'"),
        std::pair("a,1e500", "1e500"), std::pair("a,inf", "'inf'")}) {
    const OtherAnswer a = csv("id,quantities", row);
    check_garbage(a, part);
    check_garbage(a, "a.csv:2: ");
    CHECK(a.id == "a");
  }
  check_garbage(csv("id,quantities", "\"a,1"), "quote");
  check_garbage(csv("id,quantities,sizes_mm", "a,1,0x1"), "'0x1'");
}

TEST_CASE("a CSV row without quantities is no answer", "[study]") {
  const OtherAnswer a = csv("id,quantities,sizes_mm,knob", "a,,,7");
  CHECK(a.failure == AnswerVerdict::no_answer);
  CHECK(a.labels.at("knob") == "7");
}

TEST_CASE("a broken header is refused", "[study]") {
  check_refused("", "there is no header");
  check_refused("# nothing\n", "there is no header");
  check_refused("a,b\n", "no column id");
  check_refused("id,b\n", "no column quantities");
  check_refused("id;quantities\n", "no column id");
  check_refused("id,quantities,id\n", "there twice");
  check_refused("id,quantities,\n", "without a name");
  check_refused("id,quantities,sizes_cm\n", "unknown unit");
  check_refused("id,quantities,sizes_mm,sizes_um\n", "second one");
  check_refused("id,\"quantities\n", "quote");
  check_refused("# c\nid,b\n", "a.csv:2: ");
}

TEST_CASE("the simple JSON form takes numbers from their text", "[study]") {
  const OtherAnswer a =
      json_answer(R"({"id":7,"quantities":[15,"2",3.0,18446744073709551616],"sizes":[0.1,"0.2",)"
                  R"(["0.3","0.4"],null],"unit":"um","knob":0.50,"deep":{"x":[1]}})");
  CHECK(!a.failure);
  CHECK(a.id == "7");
  CHECK(a.quantities == std::vector<Integer>{15, 2, 3, Integer(1) << 64});
  REQUIRE(a.sizes.size() == 4);
  CHECK(a.sizes[0]->lo == ratio(1, 10));
  CHECK(a.sizes[2]->lo == ratio(3, 10));
  CHECK(a.sizes[2]->hi == ratio(4, 10));
  CHECK(!a.sizes[3]);
  CHECK(a.unit_mm == ratio(1, 1000));
  CHECK(a.labels == std::map<std::string, std::string>{{"knob", "0.50"}});
}

TEST_CASE("an mdm-answer-1 gives all classes with their enclosures", "[study]") {
  const OtherAnswer a = json_answer(
      R"({"schema":"mdm-answer-1","id":"x","status":"optimal","particles":"3","unit":"m","classes":[)"
      R"({"lower":"0","upper":"1","mass":"1","quantity":"3","size":["0.5","0.6"]},)"
      R"({"lower":"1","upper":"2","mass":"0","quantity":"0","size":null}]})");
  CHECK(!a.failure);
  CHECK(a.quantities == integers({3, 0}));
  REQUIRE(a.sizes.size() == 2);
  CHECK(a.sizes[0]->hi == ratio(6, 10));
  CHECK(!a.sizes[1]);
  CHECK(a.unit_mm == 1000);
}

TEST_CASE("JSON without quantities says why", "[study]") {
  const auto check = [](const std::string &text, AnswerVerdict failure, const std::string &reason) {
    const OtherAnswer a = json_answer(text);
    INFO(text);
    CHECK(a.failure == failure);
    CHECK(a.reason == reason);
    CHECK(a.id == "x");
  };
  check(R"({"id":"x","status":"error","error":"too hard"})", AnswerVerdict::no_answer, "too hard");
  check(R"({"id":"x","status":"none","classes":[{"quantity":null,"size":null}]})", AnswerVerdict::no_answer,
        "status none");
  check(R"({"id":"x","quantities":[]})", AnswerVerdict::no_answer, "there are no quantities");
  check(R"({"id":"x","quantities":null})", AnswerVerdict::no_answer, "there are no quantities");
  check(R"({"id":"x","status":"crashed","reason":"signal 11"})", AnswerVerdict::crashed, "signal 11");
  check(R"({"id":"x","status":"timeout","reason":"r"})", AnswerVerdict::timeout, "r");
  check(R"({"id":"x","n":3})", AnswerVerdict::garbage, "there is neither \"quantities\" nor \"classes\"");
}

TEST_CASE("JSON that cannot be read is garbage", "[study]") {
  for (const std::string text : {"",
                                 "nonsense",
                                 "{",
                                 "[]",
                                 "1",
                                 "null",
                                 R"({"quantities":[1e400]})",
                                 R"({"quantities":[1],"quantities":[2]})",
                                 R"({"quantities":[true]})",
                                 R"({"quantities":[null]})",
                                 R"({"quantities":{"a":1}})",
                                 R"({"quantities":[[1]]})",
                                 R"({"quantities":["1.5"]})",
                                 R"({"quantities":[-1]})",
                                 R"({"quantities":[1],"sizes":["x"]})",
                                 R"({"quantities":[1],"sizes":[["2","1"]]})",
                                 R"({"quantities":[1],"sizes":[["1","1","1"]]})",
                                 R"({"quantities":[1],"sizes":3})",
                                 R"({"quantities":[1],"unit":"ft"})",
                                 R"({"quantities":[1],"unit":3})",
                                 R"({"classes":[1]})",
                                 R"({"classes":[{}]})",
                                 R"({"classes":3})",
                                 "{\"quantities\":[1]} {}",
                                 "{\"quantities\":[\xFF]}"}) {
    INFO(text);
    check_garbage(json_answer(text), "");
  }
  check_garbage(json_answer("{\"a\":" + std::string(1'000'000, '[')), "nested deeper");
  CHECK(json_answer(R"({"id":"x","quantities":[tru)").id == "x");
}

TEST_CASE("a file that begins with a brace is JSON Lines", "[study]") {
  const std::vector<OtherAnswer> answers = read_answers(
      "\n{\"id\":\"a\",\"quantities\":[1]}\nnonsense\n\n{\"id\":\"b\",\"quantities\":[2]}", "a.jsonl");
  REQUIRE(answers.size() == 3);
  CHECK(answers[0].quantities == integers({1}));
  check_garbage(answers[1], "a.jsonl:3: ");
  CHECK(answers[2].id == "b");
}

TEST_CASE("an answer's line is read back as it was", "[study]") {
  const OtherAnswer a = json_answer(
      R"({"id":"\u0000\"","quantities":["1","200000000000000000000"],"sizes":[["0.1","0.2"],null],"unit":"in"})");
  const OtherAnswer b = json_answer(answer_line(a, {{"solver", "x \"y\""}}));
  CHECK(b.id == a.id);
  CHECK(b.quantities == a.quantities);
  REQUIRE(b.sizes.size() == 2);
  CHECK(b.sizes[0]->lo * b.unit_mm == ratio(254, 100));
  CHECK(b.sizes[0]->hi * b.unit_mm == ratio(508, 100));
  CHECK(!b.sizes[1]);
  CHECK(b.labels.at("solver") == "x \"y\"");
  const OtherAnswer c = json_answer(answer_line(failed_answer("i", AnswerVerdict::garbage, "no\nsense"), {}));
  CHECK(c.failure == AnswerVerdict::garbage);
  CHECK(c.reason == "no\nsense");
  CHECK(c.id == "i");
}

TEST_CASE("what an answer says against its quantities is known", "[study]") {
  CHECK(json_answer(R"({"id":"b","quantities":["3","1"],"particles":"2"})").contradiction ==
        "the answer says that it has 2 particles, and its quantities are 4 together");
  CHECK(json_answer(R"({"id":"b","quantities":[3,1],"particles":4})").contradiction.empty());
  for (const char *status : {"none", "infeasible", "no-answer"})
    check_garbage(json_answer(std::string(R"({"id":"b","quantities":[3,1],"status":")") + status + "\"}"),
                  "and quantities: leave one of them out");
  CHECK(!json_answer(R"({"id":"b","quantities":[3,1],"status":"optimal"})").failure);
  const std::string answer =
      R"({"id":"b","unit":"mm","particles":"3","classes":[{"lower":"1","upper":"2","quantity":"4","size":null}]})";
  CHECK(!json_answer(answer).contradiction.empty());
}

TEST_CASE("an empty id is an id", "[study]") {
  CHECK(json_answer(R"({"id":"","quantities":[1]})").has_id);
  CHECK(!json_answer(R"({"quantities":[1]})").has_id);
  CHECK(json_answer(R"({"id":"","quantities":[-1]})").has_id);
}

TEST_CASE("a CSV row that begins with # and a digit is no comment", "[study]") {
  check_garbage(csv("id,quantities", "#1,3 1"), "may be a comment or an id");
  CHECK(csv("id,quantities", "\"#1\",3 1").id == "#1");
}

TEST_CASE("rows of mdm batch have their classes in order", "[study]") {
  const std::string header = "id,class,lower_mm,upper_mm,share_percent,quantity,size_lo_mm,size_hi_mm\n";
  const std::vector<OtherAnswer> answers =
      read_answers(header + ",1,1,2,50,3,1.5,1.5\n,2,2,3,50,1,2.5,2.5\n", "a.csv");
  REQUIRE(answers.size() == 1);
  CHECK(answers[0].has_id);
  CHECK(answers[0].classes[1] == std::pair<Rational, Rational>(2, 3));
  check_refused(header + "a,1,1,2,50,3,1.5,1.5\na,3,2,3,50,1,2.5,2.5\n",
                "a.csv:3: the classes of an answer are not");
}

} // namespace other_answer_test
