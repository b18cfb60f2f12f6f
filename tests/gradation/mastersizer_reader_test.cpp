#include "gradation/mastersizer_reader.hpp"
#include "support.hpp"

namespace mastersizer_reader_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string between = "Sample Name,d (0.5),Result Between User Sizes (Sizes in um),,\n,,1,10,100\n";

Gradation read_sample(const std::string &content, const std::string &sample) {
  Reading reading;
  reading.specimen = sample;
  return read_gradation(content, "silt.csv", reading);
}

} // namespace

TEST_CASE("Mastersizer: shares between a size and the next, the last of none") {
  const Gradation g = read(between + "A,5,40,60,\n");
  CHECK(g.unit() == SizeUnit::um);
  CHECK(text(g.sizes()) == "1 10 100");
  CHECK(text(g.masses()) == "40 60 0");
  CHECK(g.id() == "A");
  CHECK(
      text(
          read("Sample Name;x;Result Between User Sizes (Sizes in mm);;\n;;0,001;0,01;0,1\nA;5;40,5;59,5;0\n")
              .sizes()) == "0.001 0.01 0.1");
}

TEST_CASE("Mastersizer: shares under a size") {
  CHECK(text(read("Sample Name,Result Under User Sizes (Sizes in um),,\n,1,10,100\nA,5,60,100\n").masses()) ==
        "5 55 40 0");
  CHECK(contains(refusal("Sample Name,Result Under User Sizes (Sizes in um),,\n,1,10,100\nA,5,60,99\n"),
                 "sand.csv:3: the largest sieve, 100 um, has percent passing 99"));
}

TEST_CASE("Mastersizer: one sample of several by its name, or by its line where names repeat") {
  const std::string content = between + "A,5,40,60,\nB,5,10,90,\nB,5,20,80,0\n";
  CHECK(text(read_sample(content, "A").masses()) == "40 60 0");
  CHECK(text(read_sample(content, "5").masses()) == "20 80 0");
  CHECK(contains(refusal(content), "there are 3 specimens: 'A', 'B', 'B'; choose one by --specimen-id"));
  CHECK(contains(message_of([&] { read_sample(content, "B"); }), "'B' does not name one specimen of"));
}

TEST_CASE("Mastersizer: what is wrong is refused") {
  CHECK(contains(refusal(between), "there is no row of a sample"));
  CHECK(contains(refusal(between + "A,5,40,x,0\n"), "sand.csv:3: 'x' in column 4 is no number"));
  CHECK(contains(refusal(between + "A,5,40,60,1\n"),
                 "the largest sieve, 100 um, has percent retained 1, not 0"));
  CHECK(contains(refusal("Sample Name,Result Between User Sizes,\n,1,10\nA,40,60\n"),
                 "does not name the unit"));
}

} // namespace mastersizer_reader_test
