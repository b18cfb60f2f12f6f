#include "ask/solve_options.hpp"
#include "cli/option_tables.hpp"

#include <catch.hpp>

namespace option_tables_test {

using namespace mdm;

namespace {

struct MoreTexts : SolveTexts {
  OptionText mystery_gap;
  bool mystery = false;
};

} // namespace

TEST_CASE("a row that is added to a table is an option of the command, with its help and its value") {
  std::vector<OptionRow<MoreTexts>> rows = {
      {"mystery-gap", "G", OptionKind::number, "a gap that nobody knows", &MoreTexts::mystery_gap},
      {"mystery", "", OptionKind::flag, "a flag that nobody knows", &MoreTexts::mystery}};
  CLI::App app;
  MoreTexts texts;
  cli::add_options(app, SolveTexts::limit_options, texts);
  cli::add_options(app, rows, texts);
  const std::string help = app.help();
  CHECK(help.find("--mystery-gap G") != std::string::npos);
  CHECK(help.find("a gap that nobody knows") != std::string::npos);
  app.parse("--mystery-gap 1e4 --mystery --time-limit 3");
  CHECK(texts.mystery_gap == "1e4");
  CHECK(texts.mystery);
  CHECK(texts.time_limit == "3");
}

TEST_CASE("an option with several values takes one a time") {
  CLI::App app;
  SolveTexts texts;
  std::string file;
  cli::add_options(app, SolveTexts::tolerance_options, texts);
  app.add_option("FILE", file);
  app.parse("--tolerance retained:1% a.csv --tolerance passing:2%");
  CHECK(texts.tolerances == std::vector<std::string>{"retained:1%", "passing:2%"});
  CHECK(file == "a.csv");
}

} // namespace option_tables_test
