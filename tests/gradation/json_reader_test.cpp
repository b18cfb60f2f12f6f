#include "support.hpp"

namespace json_reader_test {

using namespace mdm;
using namespace mdm::test;

namespace {

/// The message that refuses a line of a suite.
std::string line_refusal(const std::string &line) {
  INFO(line.substr(0, 200));
  return message_of([&line] { read_json_gradation(line, "suite.jsonl:7", "7"); });
}

/// An object with these masses and sizes 1, 2.
std::string with_masses(const std::string &masses) {
  return R"({"sizes": ["1", "2"], "masses": )" + masses + "}";
}

} // namespace

TEST_CASE("JSON: sizes ascend or descend, strings or numbers") {
  const Gradation up = read(R"( {"id": "g0", "sizes": ["0.0001", "0.5", 2], "masses": [3.6, "15", "0"]} )");
  CHECK(up.id() == "g0");
  CHECK(text(up.sizes()) == "0.0001 0.5 2");
  CHECK(text(up.masses()) == "3.6 15 0");
  CHECK(up.notes().empty());
  CHECK(equal(up, read(R"({"masses": [0, 15, 3.6], "sizes": [2, 0.5, 1e-4]})")));
}

TEST_CASE("JSON: units, factors, tolerances and ids") {
  const auto unit = [](const std::string &u) {
    return read(R"({"unit":")" + u + R"(","sizes":[1,2],"masses":[1,0]})");
  };
  CHECK(unit("um").unit() == SizeUnit::um);
  CHECK(unit("m").unit() == SizeUnit::m);
  CHECK(unit("mm").unit() == SizeUnit::mm);
  CHECK(text(unit("in").sizes()) == "25.4 50.8");
  CHECK(unit("in").notes() == std::vector<std::string>{"Sizes in inches were converted to mm."});
  const Gradation g =
      read(R"({"id":17,"sizes":[2,1],"masses":[0,1],"factors":["1",2.5],"tolerances_percent":[0,"0.5"]})");
  CHECK(g.id() == "17");
  CHECK(text(g.tolerances()) == "0.5 0");
  CHECK(g.factor(0) == parse_decimal("2.5"));
  CHECK(read(R"({"id":1.50,"sizes":[1,2],"masses":[1,0]})").id() == "1.50");
  CHECK(read(R"({"id":-0,"sizes":[1,2],"masses":[1,0]})").id() == "-0");
  CHECK(read(R"({"id":0,"sizes":[1,2],"masses":[1,0]})").id() == "0");
  CHECK(read(R"({"id":"","sizes":[1,2],"masses":[1,0]})").id() == "sand");
  CHECK(read_json_gradation(R"({"id":"","sizes":[1,2],"masses":[1,0]})", "suite.jsonl:7", "7").id().empty());
  CHECK(read(R"({"sizes":[1,2],"masses":[1,0]})").id() == "sand");
  CHECK(read_json_gradation(with_masses("[1,0]"), "suite.jsonl:7", "7").id() == "7");
}

TEST_CASE("JSON: numbers are read from their text, exactly") {
  CHECK(text(read(with_masses("[0.12345678901234567890123, 0]")).masses()) == "0.12345678901234567890123 0");
  CHECK(text(read(with_masses("[123456789012345678901234567890, 0]")).masses()) ==
        "123456789012345678901234567890 0");
  CHECK(text(read(with_masses("[18446744073709551615, 0]")).masses()) == "18446744073709551615 0");
  CHECK(text(read(with_masses(R"(["\u0031\u002e5", -0.0])")).masses()) == "1.5 0");
  CHECK(read(with_masses("[1e-400, 0]")).mass(0) * Rational(power_of_ten(400)) == 1);
  CHECK(read(with_masses(R"(["1e400", 0])")).mass(0) == Rational(power_of_ten(400)));
}

TEST_CASE("JSON: numbers have limits") {
  const Integer limit = power(Integer(2), 1024);
  CHECK(read(with_masses("[" + to_string(Integer(limit - 1)) + ", 0]")).mass(0) ==
        Rational(Integer(limit - 1)));
  CHECK(contains(refusal(with_masses("[" + to_string(limit) + ", 0]")),
                 "is too large for a JSON number: write it as a string"));
  CHECK(contains(refusal(with_masses("[1e400, 0]")),
                 "sand.csv:1: masses[0] '1e400' is too large for a JSON number: write it as a string"));
  CHECK(contains(refusal(with_masses("[1e999999, 0]")),
                 "sand.csv:1: masses[0] '1e999999' is too large for a JSON number"));
  for (const std::string &number : {std::string("1e999"), "1" + std::string(1000, '0')}) {
    const std::string too_large = " is too large for a JSON number: write it as a string";
    CHECK(contains(refusal(with_masses("[" + number + ", 0]")), too_large));
    CHECK(contains(refusal("{\"id\":" + number + "}"), too_large));
    CHECK(contains(refusal("{\"sizes\":[-" + number + "]}"), too_large));
  }
  CHECK(contains(refusal(with_masses("[1e-401, 0]")),
                 "sand.csv:1: masses[0] '1e-401' has an exponent beyond 400"));
  CHECK(contains(refusal(with_masses("[1." + std::string(1000, '0') + ", 0]")), "has more than 1000 digits"));
  CHECK(contains(refusal(with_masses("[" + std::string(10'000'000, '1') + ", 0]")), "masses[0] '1111"));
}

TEST_CASE("JSON: strings hold exactly one decimal") {
  for (const std::string word : {"", " 1", "1 ", "1,5", "nan", "1 2", "pan", "Infinity"})
    CHECK(contains(refusal(with_masses("[\"" + word + "\", 0]")),
                   "sand.csv:1: masses[0] '" + word + "' is not a number"));
}

TEST_CASE("JSON: edge 1: an unknown key is refused, and the nearest known one named") {
  const auto with_key = [](const std::string &key) {
    return refusal("{\"sizes\":[1,2],\n\"" + key + "\":[{\"x\":null}],\"masses\":[1,0]}");
  };
  CHECK(contains(with_key("factor"), "sand.csv:2: key 'factor' is unknown: is it \"factors\"?"));
  CHECK(contains(with_key("units"), "is it \"unit\"?"));
  CHECK(contains(with_key("Masses"), "is it \"masses\"?"));
  CHECK(contains(with_key("ID"), "is it \"id\"?"));
  CHECK(contains(with_key("tolerance"), "is it \"tolerances_percent\"?"));
  CHECK(contains(with_key("comment"), "key 'comment' is unknown: leave it out; there are \"sizes\", "));
  CHECK(contains(with_key(std::string(1000, 's')), "leave it out"));
  CHECK(contains(with_key(""), "key '' is unknown: leave it out"));
}

TEST_CASE("JSON: edge 2: an id that is a number has the limits of a number") {
  const auto id = [](const std::string &number) {
    return "{\"id\":" + number + R"(,"sizes":[1,2],"masses":[1,0]})";
  };
  CHECK(read(id("1e300")).id() == "1e300");
  CHECK(read(id("1." + std::string(999, '0'))).id().size() == 1001);
  for (const std::string &number : {std::string("1e-401"), "1." + std::string(1000, '0'),
                                    std::string(1001, '1'), std::string("1e-99999")})
    CHECK(contains(refusal(id(number)), "write it as a string"));
}

TEST_CASE("JSON: no key twice in one object") {
  CHECK(contains(refusal("{\"sizes\":[1,2],\n\"masses\":[1,0],\n\"sizes\":[1,2]}"),
                 "sand.csv:3: key 'sizes' is there twice"));
  CHECK(contains(refusal(R"({"id":1,"\u0069d":2})"), "sand.csv:1: key 'id' is there twice"));
}

TEST_CASE("JSON: values are nested no deeper than they need be") {
  CHECK(contains(refusal(R"({"sizes":)" + std::string(1'000'000, '[')),
                 "sizes[0] is an array: write a decimal"));
  CHECK(contains(refusal(R"({"id":{"sizes":[1,2]}})"), "id is an object"));
}

TEST_CASE("JSON: wrong types say what belongs there") {
  CHECK(contains(refusal(with_masses("1")), "masses is a number: write an array of decimals"));
  CHECK(contains(refusal(with_masses("\"1\"")), "masses is a string: write an array of decimals"));
  CHECK(contains(refusal(with_masses("{}")), "masses is an object: write an array of decimals"));
  CHECK(contains(refusal(with_masses("[1, null]")), "masses[1] is null: write a decimal"));
  CHECK(contains(refusal(with_masses("[true, 0]")), "masses[0] is a truth value: write a decimal"));
  CHECK(contains(refusal(with_masses("[[1], 0]")), "masses[0] is an array: write a decimal"));
  CHECK(contains(refusal(R"({"unit": 1})"), "unit is a number: write \"mm\", \"um\", \"m\" or \"in\""));
  CHECK(contains(refusal(R"({"unit": "MM"})"), "unit 'MM' is unknown: use \"mm\", \"um\", \"m\" or \"in\""));
  CHECK(contains(refusal(R"({"id": null})"), "id is null: write a string or a number"));
}

TEST_CASE("JSON: what is no JSON is refused with its place") {
  CHECK(
      contains(refusal(with_masses("[1,0]") + " x"), "sand.csv:1: this is not JSON at byte 40 of the line"));
  CHECK(contains(refusal("{\"sizes\":[1,2],\n \"masses\":[1,,0]}"),
                 "sand.csv:2: this is not JSON at byte 14 of the line, the end of"));
  for (const std::string bad :
       {"{", "{\"sizes\":[1", "{,}", "{\"id\" 1}", "{'id':1}", "{\"id\":01}", "{\"id\":+1}", "{\"id\":.5}",
        "{\"id\":NaN}", "{\"id\":1}{", "{\"id\":\"\\ud800\"}", "{\"id\":1,}", "{} //"})
    CHECK(contains(refusal(bad), "sand.csv:1: this is not JSON"));
  CHECK(contains(line_refusal(""), "suite.jsonl:7: there is no JSON object"));
  CHECK(contains(line_refusal("[1]"), "suite.jsonl:7: there is no JSON object"));
  CHECK(contains(line_refusal("size_mm,mass"), "suite.jsonl:7: there is no JSON object"));
}

TEST_CASE("JSON: a gradation is complete") {
  CHECK(contains(refusal("{}"), "sand.csv:1: key \"sizes\" is missing"));
  CHECK(contains(refusal(R"({"sizes":[1,2]})"), "key \"masses\" is missing"));
  CHECK(contains(refusal(R"({"sizes":[1],"masses":[0]})"),
                 "sizes has 1 entries: a gradation needs at least two"));
  CHECK(contains(refusal("{\"sizes\":[1,2],\n\"masses\":[1,2,0],\n\"id\":1}"),
                 "sand.csv:2: masses has 3 entries, sizes has 2"));
  CHECK(contains(refusal(R"({"sizes":[1,2],"masses":[1,0],"factors":[]})"),
                 "factors has 0 entries, sizes has 2"));
  CHECK(contains(
      line_refusal(with_masses("[1,2]")),
      "suite.jsonl:7: masses: the largest sieve, 2 mm, retains 2: add a larger sieve that retains 0"));
  CHECK(contains(refusal(with_masses("[0,0]")), "masses: no sieve retains anything"));
  CHECK(line_refusal(with_masses("[-1,0]")) ==
        "suite.jsonl:7: masses[0] -1 is negative: write a number from 0 on");
  CHECK(contains(refusal(R"({"sizes":[1,2,1.5],"masses":[1,1,0]})"), "sizes[2] 1.5 breaks the order"));
  CHECK(contains(refusal(R"({"sizes":[1,1.0],"masses":[1,0]})"), "sizes[1] 1 repeats the size before it"));
  CHECK(contains(refusal(R"({"sizes":[-1,1],"masses":[1,0]})"), "sizes[0] -1 is negative"));
  CHECK(
      contains(refusal(R"({"sizes":[1,2],"masses":[1,0],"factors":[0,1]})"), "factors[0] 0 is not above 0"));
  CHECK(contains(refusal(R"({"sizes":[1,2],"masses":[1,0],"tolerances_percent":[0,-1]})"),
                 "tolerances_percent[1] -1 is negative"));
}

TEST_CASE("JSON: byte order marks and bytes") {
  CHECK(text(read("\xEF\xBB\xBF \r\n" + with_masses("[1,0]")).sizes()) == "1 2");
  CHECK(contains(refusal("\xEF\xBB\xBF\xEF\xBB\xBF" + with_masses("[1,0]")), "sand.csv:1: "));
  CHECK(contains(line_refusal("{\"id\":\"\xFF\"}"), "suite.jsonl:7: the text is not UTF-8"));
  CHECK(
      contains(refusal(with_masses("[1,0]") + std::string(1, '\0') + "x"), "the control character '\\x00'"));
}

} // namespace json_reader_test
