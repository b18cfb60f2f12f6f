// The log of a triaxial model: what is read and what is refused.

#include "catch.hpp"
#include "report/triaxial_log.hpp"

#include <mdm/text/error.hpp>

namespace triaxial_log_test {

using namespace mdm;

namespace {

const std::string header =
    "axial_strain,volumetric_strain,p,q,void_ratio,coordination,unbalanced_force,constant\n";
const std::string rows = "0,0,100000,-12.5,0.52,4.5,0.003,p\n0.1,-1.5e-3,140000,120000,0.53,4.25,0.01,p\n";

std::string triaxial_refusal(const std::string &text) {
  try {
    read_triaxial_log(text, "log.csv");
  } catch (const InputError &e) {
    return e.what();
  }
  FAIL("no InputError");
  return {};
}

bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a triaxial log is told by its first line alone") {
  CHECK(is_triaxial_log(header));
  CHECK(is_triaxial_log("\xEF\xBB\xBF" + header.substr(0, header.size() - 1) + "\r\n" + rows));
  CHECK(!is_triaxial_log(""));
  CHECK(!is_triaxial_log("size_mm,mass\n" + header));
  CHECK(!is_triaxial_log("axial_strain,q\n"));
}

TEST_CASE("the rows of a triaxial log are read exactly") {
  const TriaxialLog log = read_triaxial_log(header + rows + "\n", "log.csv");
  const std::vector<TriaxialState> &states = log.states;
  CHECK(log.constant == "p");
  REQUIRE(states.size() == 2);
  CHECK(states[0].q == ratio(-25, 2));
  CHECK(states[1].axial_strain == ratio(1, 10));
  CHECK(states[1].volumetric_strain == ratio(-3, 2000));
  CHECK(states[1].p == 140000);
  CHECK(states[1].void_ratio == ratio(53, 100));
  CHECK(states[1].coordination == ratio(17, 4));
  CHECK(states[1].unbalanced_force == ratio(1, 100));
}

TEST_CASE("a triaxial log is refused with its line") {
  CHECK(has(triaxial_refusal("axial_strain,q\n0,1\n"), "log.csv:1: the first line is not axial_strain,vol"));
  CHECK(has(triaxial_refusal(header), "log.csv: fewer than two rows"));
  CHECK(has(triaxial_refusal(header + "0,0,1,1,0.5,4,0,p\n"), "fewer than two rows"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,0,140000\n"), "log.csv:4: 3 fields, not 8"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,0,1,1,0.5,4,0,p,9\n"), "log.csv:4: 9 fields, not 8"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,nan,1,1,0.5,4,0,p\n"),
            "log.csv:4: volumetric_strain: 'nan'"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,0,1,,0.5,4,0,p\n"), "log.csv:4: q: "));
  CHECK(has(triaxial_refusal(header + rows + "0.1,0,1,1,0.5,4,0,p\n"),
            "log.csv:4: axial_strain '0.1' is not above that of the row before"));
  CHECK(has(triaxial_refusal(header + rows + "20,0,1,1,0.5,4,0,p\n"), "strains are parts, not percent"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,0,1,1,-0.5,4,0,p\n"), "void_ratio '-0.5' is below 0"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,0,1,1,0.5,-4,0,p\n"), "coordination '-4' is below 0"));
  CHECK(has(triaxial_refusal(header + rows + "\"0.2,0,1,1,0.5,4,0,p\n"), "log.csv:4: a quoted field"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,0,1,1,0.5,4,0,q\n"),
            "constant 'q' is neither sigma_3 nor p"));
  CHECK(has(triaxial_refusal(header + rows + "0.2,0,1,1,0.5,4,0,sigma_3\n"),
            "log.csv:4: constant 'sigma_3' is another than that of the row before, p"));
}

} // namespace triaxial_log_test
