#include "answer/answer.hpp"
#include "catch.hpp"

#include <mdm/match/solve.hpp>

#include <nlohmann/json.hpp>

namespace answer_test {

using namespace mdm;
using Json = nlohmann::json;

namespace {

/// Classes (1, 2], (2, 3], empty (3, 4], pan at 0 with mass.
Match example(const SolveOptions &options = {}) {
  Gradation::Data data;
  data.id = "a \"quoted\"\nname";
  data.sizes = {0, 1, 2, 3, 4};
  data.masses = {1, 2, 1, 0, 0};
  data.notes = {"a note"};
  return solve(Gradation(std::move(data)), {}, options);
}

} // namespace

TEST_CASE("the JSON answer has the schema's keys, and exact numbers are strings") {
  const Match m = example();
  const std::string text = answer_json(m);
  CHECK(text.find('\n') == std::string::npos);
  const Json j = Json::parse(text);
  CHECK(j["schema"] == "mdm-answer-1");
  CHECK(j["id"] == "a \"quoted\"\nname");
  CHECK(j["status"] == "optimal");
  CHECK(j["particles"] == to_string(*m.particles()));
  CHECK(j["lower_bound"] == j["particles"]);
  CHECK(j["unit"] == "mm");
  REQUIRE(j["classes"].size() == 4);
  CHECK(j["classes"][1]["lower"] == "1");
  CHECK(j["classes"][1]["mass"] == "2");
  CHECK(j["classes"][3]["quantity"] == "0");
  CHECK(j["classes"][3]["size"].is_null());
  CHECK(j["classes"][0]["size"].size() == 2);
  CHECK(j["scale"]["chosen"] == to_string(m.sample->scale->chosen));
  CHECK_FALSE(j["scale"].contains("scale_power"));
  CHECK(j["tolerance"].is_null());
  CHECK(j["solids_volume"].size() == 2);
  CHECK(j["notes"][0] == "a note");
  CHECK(j["versions"].contains("gmp"));
}

TEST_CASE("without an answer the JSON says what is certain") {
  SolveOptions options;
  options.at_most = 1;
  const Json j = Json::parse(answer_json(example(options)));
  CHECK(j["status"] == "none");
  CHECK(j["particles"].is_null());
  CHECK(j["lower_bound"] == to_string(*example().particles()));
  CHECK(j["classes"][0]["quantity"].is_null());
  CHECK(j["scale"].is_null());
}

TEST_CASE("a power law with a root names the power of its scales") {
  Gradation::Data data;
  data.sizes = {1, 2, 4};
  data.masses = {1, 1, 0};
  Question q;
  q.law = {5, 2};
  const Json j = Json::parse(answer_json(solve(Gradation(std::move(data)), q)));
  CHECK(j["scale"]["scale_power"] == "2");
  CHECK(j["solids_volume"].is_null());
}

TEST_CASE("the CSV answer has a row a class, with the unit in the header") {
  const std::string text = answer_csv(example());
  CHECK(text.rfind("lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm\n0,1,1,", 0) == 0);
  CHECK(text.find("\n3,4,0,0,,\n") != std::string::npos);
}

TEST_CASE("the text answer says N first and shows every class, the window and the notes") {
  const Spectrum spectrum{{{3, 3}, {5, 7}}, 9, true};
  const std::string text = answer_text(example(), &spectrum, nullptr, true);
  CHECK(answer_text(example(), &spectrum).find("scale") == std::string::npos);
  CHECK(text.find(to_string(*example().particles()) + " particles: the smallest set") != std::string::npos);
  CHECK(text.find("(3, 4]") != std::string::npos);
  CHECK(text.find("scale: s above ") != std::string::npos);
  CHECK(text.find("    5 to 7\n") != std::string::npos);
  CHECK(text.find("every number from 9 on") != std::string::npos);
  CHECK(text.find("note: a note") != std::string::npos);
}

} // namespace answer_test
