#include "catch.hpp"
#include "text/json_member.hpp"

namespace json_member_test {

using namespace mdm;

TEST_CASE("a JSON text says its schema in any place and spelling of the key") {
  CHECK(json_schema(R"({"schema":"mdm-answer-1","id":"a"})") == "mdm-answer-1");
  CHECK(json_schema("\uFEFF\n{\"id\": \"a\",\n \"schema\"\t: \"x\"}") == "x");
  CHECK(json_schema(R"({"sch\u0065ma":"x"})") == "x");
  CHECK(json_schema(R"({"classes":[{"id":"b"}],"schema":"x"})") == "x");
}

TEST_CASE("a schema that is not the outermost object's own is none") {
  CHECK_FALSE(json_schema(R"({"id":"\"schema\":"})"));
  CHECK_FALSE(json_schema(R"({"id":"schema"})"));
  CHECK_FALSE(json_schema(R"({"a":{"schema":"x"}})"));
  CHECK_FALSE(json_schema(R"([{"schema":"x"}])"));
  CHECK_FALSE(json_schema(R"({"schema":{"schema":"x"}})"));
  CHECK_FALSE(json_schema("size_mm,mass\n1,2\n"));
  CHECK_FALSE(json_schema(""));
}

TEST_CASE("a member is found before an error, not behind one") {
  CHECK(json_member(R"({"id":-0,"x)", "id") == "-0");
  CHECK(json_member(R"({"id":18446744073709551615)", "id") == "18446744073709551615");
  CHECK_FALSE(json_member(R"({"x,"id":"a"})", "id"));
}

} // namespace json_member_test
