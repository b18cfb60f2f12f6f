// The particles of an answer as another program's answer is read for them; the whole answer:
// answer_sample_test.

#include "answer/answer_reader.hpp"
#include "catch.hpp"

#include <mdm/text/error.hpp>

namespace answer_reader_test {

using namespace mdm;

namespace {

using Json = nlohmann::json;

StatedParticles particles_of(const std::string &text) {
  const Json answer = Json::parse(text);
  return AnswerReader(answer).particles();
}

std::string refusal_of(const std::string &text) {
  try {
    particles_of(text);
  } catch (const InputError &error) {
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

} // namespace

TEST_CASE("stated particles: all classes, with sizes where there are particles") {
  const StatedParticles p = particles_of(
      R"({"unit":"um","classes":[{"quantity":"0","size":null},{"quantity":"20","size":["0.5","0.6"]}]})");
  REQUIRE(p.classes.size() == 2);
  CHECK(p.classes[0].quantity == 0);
  CHECK_FALSE(p.classes[0].size);
  CHECK(p.classes[1].quantity == 20);
  CHECK(p.classes[1].size->first == ratio(1, 2));
  CHECK(p.classes[1].size->second == ratio(6, 10));
  CHECK(p.unit == SizeUnit::um);
}

TEST_CASE("stated particles: none where the answer has no match") {
  CHECK(particles_of(R"({"unit":"mm","classes":[{"quantity":null,"size":null}]})").classes.empty());
  CHECK(particles_of(R"({"unit":"mm","classes":[]})").classes.empty());
}

TEST_CASE("stated particles: what is wrong is named by its key") {
  const std::string by = ": give the JSON answer of mdm solve";
  CHECK(refusal_of("{}") == "classes is missing" + by);
  CHECK(refusal_of(R"({"classes":3})") == "classes is no array" + by);
  CHECK(refusal_of(R"({"classes":[1]})") == "classes[0].quantity is missing" + by);
  CHECK(refusal_of(R"({"classes":[{"quantity":"1.5","size":null}]})") ==
        "classes[0].quantity '1.5' is not a whole number" + by);
  CHECK(refusal_of(R"({"classes":[{"quantity":"1"}]})") == "classes[0].size is missing" + by);
  CHECK(refusal_of(R"({"classes":[{"quantity":"1","size":["2","1"]}]})") ==
        "classes[0].size is not 0 <= lo <= hi" + by);
  CHECK(refusal_of(R"({"unit":"ft","classes":[{"quantity":"1","size":["1","2"]}]})") ==
        "unit 'ft' is unknown: use mm, um or m");
}

} // namespace answer_reader_test
