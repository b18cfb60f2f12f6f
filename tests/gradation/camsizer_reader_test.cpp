#include "gradation/camsizer_reader.hpp"
#include "support.hpp"

namespace camsizer_reader_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string head = "CAMSIZER\r\nSize class [mm]\tp3 [%]\tQ3 [%]\tSPHT3\r\n";

} // namespace

TEST_CASE("CAMSIZER: p3 of each class, up to the row without numbers") {
  const Gradation g = read(head + "0.000\t0.063\t1.2\t1.2\t0.9\r\n0.063\t2.000\t98.8\t100.0\t0.9\r\n"
                                  "Shape class\tQ3(SPHT) [%]\r\n0.0\t0.1\t0.2\t0.3\r\n");
  CHECK(text(g.sizes()) == "0 0.063 2");
  CHECK(text(g.masses()) == "1.2 98.8 0");
  CHECK(g.unit() == SizeUnit::mm);
}

TEST_CASE("CAMSIZER: localised words, decimal commas, micrometres") {
  const Gradation g = read("Größen\tklasse [µm]\tp3 [%]\tQ3 [%]\n0\t63,5\t1,2\t1,2\n63,5\t2000\t98,8\t100,0\n"
                           "Form\tklasse\n");
  CHECK(text(g.sizes()) == "0 63.5 2000");
  CHECK(g.unit() == SizeUnit::um);
}

TEST_CASE("CAMSIZER: Q3 may differ from the sum of p3 by what the digits round, and no more") {
  CHECK(text(read(head + "0\t1\t33.3\t33.3\n1\t2\t33.3\t66.7\n2\t3\t33.3\t100.0\n").masses()) ==
        "33.3 33.3 33.3 0");
  CHECK(contains(refusal(head + "0\t1\t33.3\t33.3\n1\t2\t33.3\t66.8\n"),
                 "sand.csv:4: Q3 is 66.8, but p3 adds up to 66.6 so far"));
  CHECK(contains(refusal(head + "1\t2\t33.3\t66.8\n2\t3\t33.2\t100\n"),
                 "sand.csv:3: Q3 is 66.8, but p3 adds up"));
}

TEST_CASE("CAMSIZER: classes must follow each other") {
  CHECK(
      contains(refusal(head + "0\t1\t50.0\t50.0\n2\t3\t50.0\t100.0\n"), "sand.csv:4: the class begins at 2"));
  CHECK(contains(refusal(head + "1\t1\t50.0\t50.0\n"), "sand.csv:3: the class from 1 to 1 is empty"));
  CHECK(contains(refusal(head + "Form\n"), "sand.csv:2: there is no row of a size class"));
}

} // namespace camsizer_reader_test
