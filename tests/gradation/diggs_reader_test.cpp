#include "gradation/diggs_reader.hpp"
#include "support.hpp"

namespace diggs_reader_test {

using namespace mdm;
using namespace mdm::test;

namespace {

std::string grading(const std::string &size, const std::string &passing, const std::string &unit = "mm") {
  return "<geo:gradingData><geo:Grading><geo:particleSize uom=\"" + unit + "\">" + size +
         "</geo:particleSize>\n<geo:percentPassing uom=\"%\"> " + passing +
         " </geo:percentPassing></geo:Grading></geo:gradingData>\n";
}

std::string size_test(const std::string &id, const std::string &gradings) {
  return "<Test gml:id=\"t" + id + "\"><gml:name>name " + id + "</gml:name><geo:ParticleSizeTest gml:id=\"p" +
         id + "\"><geo:SieveAnalysis>" + gradings + "</geo:SieveAnalysis></geo:ParticleSizeTest></Test>\n";
}

std::string file(const std::string &tests) {
  return "<?xml version=\"1.0\"?>\n<Diggs>\n" + tests + "</Diggs>\n";
}

Gradation read_sample(const std::string &content, const std::string &sample) {
  Reading reading;
  reading.specimen = sample;
  return read_gradation(content, "site.xml", reading);
}

const std::string sand = grading("2", "100") + grading("0.063", "8");

} // namespace

TEST_CASE("DIGGS: the gradings of a test, whatever the prefix of their names") {
  const Gradation g = read(file(size_test("1", sand + grading("20", "2.5", "um"))));
  CHECK(text(g.sizes()) == "0 0.02 0.063 2");
  CHECK(text(g.masses()) == "2.5 5.5 92 0");
  CHECK(g.id() == "p1");
}

TEST_CASE("DIGGS: one of several tests by its id, or that of the Test around it, or its name") {
  const std::string two =
      file(size_test("1", sand) + size_test("2", grading("4", "100") + grading("1", "0")));
  for (const std::string name : {"p2", "t2", "name 2"})
    CHECK(text(read_sample(two, name).sizes()) == "1 4");
  CHECK(contains(refusal(two), "sand.csv:3: there are 2 specimens: 'p1', 'p2'; choose one by --specimen-id"));
  CHECK(contains(message_of([&] { read_sample(two, "p3"); }), "'p3' does not name one specimen of"));
}

TEST_CASE("DIGGS: a second size or percentage of one Grading is refused") {
  const std::string size = "<particleSize uom=\"mm\">2</particleSize>",
                    passing = "<percentPassing>100</percentPassing>";
  CHECK(contains(refusal(file(size_test("1", "<Grading>" + size + passing +
                                                 "\n<percentPassing>50</percentPassing></Grading>"))),
                 "sand.csv:4: a second percentPassing of the same Grading: leave one out"));
  CHECK(contains(refusal(file(size_test("1", "<Grading>" + size + size + passing + "</Grading>"))),
                 "a second particleSize of the same Grading"));
}

TEST_CASE("DIGGS: what is wrong is refused with its line") {
  CHECK(contains(refusal("<Diggs/>"), "sand.csv:1: this XML has no ParticleSizeTest"));
  CHECK(contains(refusal(file(size_test("1", grading("2", "100", "ft")))),
                 "sand.csv:3: particleSize has the unit 'ft'"));
  CHECK(contains(refusal(file(size_test("1", grading("x", "100")))),
                 "sand.csv:3: particleSize 'x' is not a number"));
  CHECK(contains(refusal(file(size_test("1", "<Grading><particleSize/></Grading>"))),
                 "has no particleSize or no"));
  CHECK(contains(refusal(file(size_test("1", ""))), "a gradation needs at least two rows"));
  CHECK(contains(refusal("<Diggs><a></Diggs>"), "the file is no sound XML at byte"));
  CHECK(contains(refusal("<!DOCTYPE a [<!ENTITY b \"c\">]><Diggs>&b;</Diggs>"), "has a document type (DTD)"));
}

} // namespace diggs_reader_test
