#include "catch.hpp"
#include "particles/packing_export.hpp"

#include <mdm/number/decimal.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace packing_export_test {

using namespace mdm;

namespace {

Packing two_discs(const std::string &unit) {
  Packing p;
  p.unit = unit;
  p.places = 2;
  p.width = 1000;
  p.discs = {{100, 100, 100, on_floor, on_floor}, {305, 105, 105, 0, on_right_wall}};
  return p;
}

using Write = void (*)(const Packing &, SizeUnit, const Rational &, const Sink &);

std::string written(Write write, const Packing &p, SizeUnit unit = SizeUnit::m) {
  std::string text;
  write(p, unit, 2650, [&text](std::string_view part) { text += part; });
  return text;
}

/// The words of the line that begins so.
std::vector<std::string> words(const std::string &text, const std::string &begin) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(begin, 0) == 0) {
      std::istringstream in(line);
      std::vector<std::string> all;
      for (std::string word; in >> word;)
        all.push_back(word);
      return all;
    }
  return {};
}

} // namespace

TEST_CASE("packings are written for LAMMPS in the plane z = 0, exactly in the unit that was asked for") {
  const std::string text = written(write_packing_lammps, two_discs("mm"));
  CHECK(words(text, "2 1") ==
        std::vector<std::string>{"2", "1", "0.0021", "2650", "0.00305", "0.00105", "0"});
  CHECK(text.find("0 0.01 xlo xhi\n0 0.0021 ylo yhi\n-0.00052 0.00052 zlo zhi\n") != std::string::npos);
  CHECK(text.find("enforce2d") < text.find('\n'));
  const std::string slab = written(write_packing_liggghts, two_discs("mm"), SizeUnit::mm);
  CHECK(slab.find("-1.05 1.05 zlo zhi\n") != std::string::npos);
  CHECK(words(slab, "2 1") == std::vector<std::string>{"2", "1", "2.1", "2.65e-6", "3.05", "1.05", "0"});
}

TEST_CASE("packings are written for YADE with the way to keep them in their plane") {
  const std::string text = written(write_packing_yade, two_discs("um"), SizeUnit::mm);
  CHECK(words(text, "0.00305") == std::vector<std::string>{"0.00305", "0.00105", "0", "0.00105"});
  CHECK(text.find("blockedDOFs = 'zXY'") != std::string::npos);
}

TEST_CASE("a table for LMGC90 has radius, x and y as numpy reads them") {
  const std::string text = written(write_packing_lmgc90, two_discs("in"), SizeUnit::mm);
  CHECK(words(text, "26.67") == std::vector<std::string>{"26.67", "77.47", "26.67"});
}

TEST_CASE("the head of a file says what its lengths are, and what is around the discs") {
  const auto head = [](const Packing &p) {
    const std::string text = written(write_packing_lammps, p, SizeUnit::mm);
    return text.substr(0, text.find(';'));
  };
  Packing p = two_discs("");
  CHECK(head(p) == "2 discs that do not overlap, lengths without a unit, sides periodic");
  p.unit = "um";
  p.periodic = false;
  CHECK(head(p) == "2 discs that do not overlap, lengths in mm, sides walls");
  p.rule = DepositRule::apollonian;
  CHECK(head(p) == "2 discs that do not overlap, lengths in mm, inside a circle");
}

TEST_CASE("packings without a unit keep their numbers") {
  CHECK(written(write_packing_csv, two_discs("")) == "x,y,radius,left,right\n1,1,1,floor,floor\n"
                                                     "3.05,1.05,1.05,0,right-wall\n");
  const std::string vtk = written(write_packing_vtk, two_discs(""));
  CHECK(vtk.find("POINTS 2 double\n1 1 0\n3.05 1.05 0\nVERTICES 2 4\n1 0\n1 1\nPOINT_DATA 2\n") !=
        std::string::npos);
}

} // namespace packing_export_test
