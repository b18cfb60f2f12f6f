// mdm study --paper voivret: the tables of its figures on size distributions, with all their rows.

#include "cli/run.hpp"

namespace voivret_tables_test {

using namespace cli_test;
using mdm_test::line_count;

TEST_CASE("study --paper voivret writes the numbers of its figures on size distributions") {
  if (MDM_IS_SANITIZED) // all of them: a minute there
    return;
  const TemporaryFolder folder;
  const Outcome outcome =
      cli_test::mdm({"study", "--paper", "voivret", "--only", "models", "--out", folder / "study"});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  const std::pair<const char *, std::ptrdiff_t> rows[] = {
      {"1", 100}, {"3", 1407}, {"4", 294}, {"5", 180}, {"6", 48}, {"7", 66}, {"8", 2304}, {"8-spans", 2000}};
  for (const auto &[number, n] : rows)
    CHECK(line_count(folder / ("study/figure" + std::string(number) + ".csv")) == n + 1);
  CHECK(line_count(folder / "study/statements.csv") > 40);
  const std::string sets = read_file(folder / "study/figure7.csv");
  CHECK(sets.find("\n1,3,geometric,10,10,2000,33927,33927,10,0.01") != std::string::npos);
  CHECK(sets.find("\n1,3,regular,10,10,2000,7258942,7258942,0,,,\n") != std::string::npos);
}

} // namespace voivret_tables_test
