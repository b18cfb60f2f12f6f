#include "packing/packing_reader.hpp"
#include "packing/support.hpp"
#include "replaced.hpp"

namespace packing_file_test {

using namespace mdm;
using namespace packing_test;
using mdm_test::replaced;

TEST_CASE("a packing file is read as it was written") {
  DepositOptions o;
  for (const bool periodic : {true, false}) {
    o.periodic = periodic;
    o.rule = periodic ? DepositRule::lowest : DepositRule::drop;
    o.floor = periodic ? FloorRule::centred : FloorRule::left;
    o.seed = 18446744073709551615U;
    Packing p = deposit(discs(50, 3), o);
    p.unit = periodic ? "" : "mm";
    CHECK(is_packing(file_text(p)));
    CHECK(read_packing(file_text(p), "a.packing") == p);
  }
}

TEST_CASE("packing files that are not whole are refused with their line") {
  const std::string text = file_text(deposit(discs(20, 2)));
  const auto message = [](const std::string &changed) {
    return refusal([&changed] { read_packing(changed, "a.packing"); });
  };
  CHECK(message(text).empty());
  CHECK(has(message(""), "a.packing"));
  CHECK(has(message(""), "first line"));
  CHECK(has(message(replaced(text, "packing 1", "packing 2")), "a.packing:1:"));
  CHECK(has(message(replaced(text, "unit any", "unit ell")), "a.packing:2:"));
  CHECK(has(message(replaced(text, "places ", "places 99")), "a.packing:3:"));
  CHECK(has(message(replaced(text, "width ", "width -")), "a.packing:4:"));
  CHECK(has(message(replaced(text, "periodic", "round")), "a.packing:5:"));
  CHECK(has(message(replaced(text, "seed 1\n", "")), "'seed ...' is missing"));
  CHECK(has(message(replaced(text, "discs 20", "discs 21")), "fewer discs"));
  CHECK(has(message(replaced(text, "discs 20", "discs 19")), "more lines"));
  CHECK(has(message(replaced(text, "discs 20", "discs 1e9")), "a.packing:11:"));
  CHECK(has(message(replaced(text, " floor floor\n", " floor\n")), "five fields"));
  CHECK(has(message(replaced(text, " floor floor\n", " 7 floor\n")), "support"));
  CHECK(has(message(replaced(text, " floor floor\n", "0 floor floor\n")), "a.packing:"));
}

} // namespace packing_file_test
