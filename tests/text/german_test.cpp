// Texts in German. The cases are those of tests/german, which the page's matcher has too.

#include "catch.hpp"
#include "files.hpp"
#include "text/german.hpp"

#include <nlohmann/json.hpp>

namespace german_test {

using namespace mdm;
using Json = nlohmann::ordered_json;

namespace {

Json shared_cases() {
  return Json::parse(mdm_test::read_file(MDM_SOURCE_DIR "/tests/german/cases.json"));
}

void check(const Json &cases, const Translator &translator) {
  REQUIRE(cases.size() > 10);
  for (const Json &one : cases) {
    const auto text = one[0].get<std::string>();
    INFO(text);
    CHECK(translator.german(text) ==
          (one[1].is_null() ? std::nullopt : std::optional(one[1].get<std::string>())));
  }
}

} // namespace

TEST_CASE("a text is German by the row that matches all of it", "[german]") {
  const Json shared = shared_cases();
  std::vector<GermanText> rows;
  for (const auto &[group, texts] : shared["table"].items())
    for (const Json &text : texts)
      rows.push_back({group, text[0].get_ref<const std::string &>(), text[1].get_ref<const std::string &>()});
  check(shared["cases"], Translator(rows));
}

TEST_CASE("the notes of the programs have German texts", "[german]") {
  check(shared_cases()["notes"], Translator(german_texts()));
}

TEST_CASE("a long text stays as it is, and one made to be slow ends", "[german]") {
  CHECK(in_german("GRAT_TYPE: " + std::string(1988, 'x') + "."));
  CHECK_FALSE(in_german("GRAT_TYPE: " + std::string(1989, 'x') + "."));
  std::string hostile;
  while (hostile.size() < 1990)
    hostile += hostile.size() % 3 == 0 ? ": " : hostile.size() % 3 == 1 ? ", " : " is ";
  CHECK_FALSE(in_german("The rows of " + hostile));
}

} // namespace german_test
