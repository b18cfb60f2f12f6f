// What the readers of gradations say of options, as each front end spells them.

#include "spellings.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

namespace {

/// Why a file is refused.
auto refusal(std::string content, Reading reading = {}) {
  return [content = std::move(content), reading = std::move(reading)] {
    return refusal_of([&] { read_gradation(content, "sand.csv", reading); });
  };
}

/// All notes of a file.
auto notes(std::string content) {
  return [content = std::move(content)] {
    const Gradation g = read_gradation(content, "sand.csv");
    std::string all;
    for (const std::string &note : g.notes())
      all += note + "\n";
    return all;
  };
}

const std::string canonical = "size_mm,mass\n1,1\n2,0\n";
const std::string laboratory = "Sieve size (mm),Retained (g)\n2,0\n1,30\n0.5,20\npan,5\n";

} // namespace

TEST_CASE("A file that does not say what it holds asks for options in the spelling of the front end") {
  const Spellings all{"say which columns they are with --columns SIZE,VALUE (names or numbers), "
                      "--kind passing|retained|cumulative, --unit mm and --skip N",
                      "say which columns they are with columns SIZE,VALUE (names or numbers), "
                      "kind passing|retained|cumulative, unit mm and skip N",
                      "say which columns they are with columns SIZE,VALUE (names or numbers), "
                      "kind passing|retained|cumulative, unit mm and skip N"};
  check_spellings(refusal("a,b\n1,2\n2,3\n"), all);
  check_spellings(refusal("Sieve size,Retained (g)\n2,0\n1,30\n"),
                  {"say it with --unit mm", "say it with unit mm", "say it with unit mm"});
  check_spellings(refusal("Opening (mm),Retained (g)\n4,0\n2,5\n1,9\n0.5,20\n0.25,31\n0.125,40\n"),
                  {"say --kind cumulative if 'Retained (g)' is one, else --kind retained",
                   "say kind cumulative if 'Retained (g)' is one, else kind retained",
                   "say kind cumulative if 'Retained (g)' is one, else kind retained"});
  check_spellings(
      refusal("size_mm,passing_min_percent,passing_max_percent\n1,0,10\n2,100,100\n"),
      {"a band is for --band or --spec", "a band is for band or spec", "a band is for band or spec"});
}

TEST_CASE("An option of reading that is wrong is named in the spelling of the front end") {
  Reading one;
  one.specimen = "BH1";
  check_spellings(refusal(canonical, one),
                  {":1: --specimen-id is for", ":1: specimen_id is for", ":1: specimenId is for"});
  Reading sheet;
  sheet.sheet = "1";
  check_spellings(refusal(canonical, sheet), {"--sheet is for", "sheet is for", "sheet is for"});
  Reading single;
  single.columns = "1";
  check_spellings(refusal(laboratory, single), {"--columns: '1'", "columns: '1'", "columns: '1'"});
  Reading kind;
  kind.kind = "weight";
  check_spellings(refusal(laboratory, kind), {"--kind: 'weight'", "kind: 'weight'", "kind: 'weight'"});
  Reading unit;
  unit.unit = "um";
  check_spellings(refusal(laboratory, unit),
                  {"--unit um: the column", "unit um: the column", "unit um: the column"});
  Reading loss;
  loss.loss = Rational(2);
  check_spellings(refusal(R"({"sizes": ["1", "2"], "masses": ["1", "0"]})", loss),
                  {"--columns, --kind, --unit, --skip and --loss are",
                   "columns, kind, unit, skip and loss are", "columns, kind, unit, skip and loss are"});
}

TEST_CASE("A note of a reading names options in the spelling of the front end") {
  check_spellings(notes("Sieve size (mm),Retained (g),Remark\n2,0,a\n1,30,b\n0.5,20,c\npan,5,d\n"),
                  {"'Remark'; --columns chooses", "'Remark'; columns chooses", "'Remark'; columns chooses"});
  check_spellings(notes("size_mm,mass\n1,0.30000000000000004\n2,0\n"),
                  {"as written; --round ", "as written; round ", "as written; round "});
}

} // namespace option_spelling_test
