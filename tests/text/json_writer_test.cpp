#include "catch.hpp"
#include "text/json_writer.hpp"

namespace json_writer_test {

using namespace mdm;

namespace {

/// An object with every kind of value.
std::string all_kinds(JsonWriter json) {
  json.begin_object().key("a").string("\"x\"").key("b").plain("1/3").key("c").number(7);
  json.key("d").boolean(true).key("e").boolean(false).key("f").null();
  json.key("g").bounds("1", "2").key("h").strings({"u", "v"}).key("i").raw("{}").end_object();
  return json.take();
}

} // namespace

TEST_CASE("values of every kind have their commas and colons") {
  CHECK(all_kinds(JsonWriter()) ==
        R"({"a":"\"x\"","b":"1/3","c":"7","d":true,"e":false,"f":null,"g":["1","2"],"h":["u","v"],"i":{}})");
  CHECK(
      all_kinds(JsonWriter(JsonWriter::Spacing::open)) ==
      R"({"a": "\"x\"", "b": "1/3", "c": "7", "d": true, "e": false, "f": null, "g": ["1", "2"], "h": ["u", "v"], "i": {}})");
}

TEST_CASE("empty and nested objects and arrays have no comma too many or too few") {
  JsonWriter json;
  json.begin_array().begin_object().end_object().begin_array().begin_array().end_array().null().end_array();
  json.begin_object().key("a").begin_array().end_array().key("b").strings({}).end_object().end_array();
  CHECK(json.take() == R"([{},[[],null],{"a":[],"b":[]}])");
}

TEST_CASE("a value can begin a line") {
  JsonWriter json;
  json.begin_array();
  for (const std::uint64_t n : {1U, 2U})
    json.new_line().number(n);
  json.end_array();
  CHECK(json.take() == "[\n\"1\",\n\"2\"]");
}

TEST_CASE("a long text comes in pieces, each as long as the other but the last") {
  std::vector<std::size_t> lengths;
  std::string text;
  const Sink sink = [&](std::string_view piece) {
    lengths.push_back(piece.size());
    text += piece;
  };
  JsonWriter json(sink);
  json.begin_array();
  std::string wanted = "[";
  for (std::uint64_t n = 1000000; n < 1020000; ++n) {
    json.number(n);
    wanted += (n == 1000000 ? "\"" : ",\"") + std::to_string(n) + "\"";
  }
  CHECK(text.size() + 70000 > wanted.size());
  json.end_array().hand_on();
  CHECK(text == wanted + "]");
  CHECK(lengths.size() == 4);
  CHECK(lengths.front() >= 65536);
  CHECK(lengths.front() < 65600);
}

} // namespace json_writer_test
