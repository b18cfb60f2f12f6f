// Numbers in options: 10, 1e1 and 1_0 are the same, wherever an option takes one.

#include "all_cases.hpp"
#include "run.hpp"

namespace number_options_test {

using namespace cli_test;

namespace {

const std::string sand = example("athabasca-sand");

/// What a command with a number in place of NUMBER writes.
Outcome with_number(Arguments arguments, const std::string &number) {
  for (std::string &argument : arguments)
    for (std::size_t at; (at = argument.find("NUMBER")) != std::string::npos;)
      argument.replace(at, 6, number);
  return mdm(arguments, R"({"schema": "mdm-suite-1", "classes": 3, "sieves": {"from": 1, "ratio": 2},)"
                        R"( "masses": {"kind": "random"}})");
}

} // namespace

TEST_CASE("10, 1e1 and 1_0 are the same in every option that takes a number", "[cli]") {
  const TemporaryFolder folder;
  const std::string title =
      folder.write("title.csv", std::string(9, '\n') + "a title\nsize_mm,mass\n1,1\n2,0\n");
  const std::string lines = folder.write("lines.jsonl", R"({"sizes":["1","2"],"masses":["1","0"]})");
  const std::string sample = folder.write("sample.csv", "size_mm,quantity\n0.1,1000\n0.2,300\n0.4,9\n");
  std::size_t turn = 0; // some cases: each second, of the next option the others
  for (const Arguments &arguments : {
           Arguments{"solve", sand, "--at-least", "NUMBER"},
           Arguments{"solve", sand, "--at-most", "NUMBER"},
           Arguments{"solve", sand, "--min-per-class", "NUMBER"},
           Arguments{"solve", sand, "--digits", "NUMBER"},
           Arguments{"solve", sand, "--max-steps", "NUMBER"},
           Arguments{"solve", sand, "--size-factor", "NUMBER"},
           Arguments{"solve", sand, "--solids-volume", "NUMBER"},
           Arguments{"solve", sand, "--specimen", "box:NUMBERxNUMBERmmx5", "--void-ratio", "NUMBER"},
           Arguments{"solve", sand, "--law", "power:NUMBER/NUMBER"},
           Arguments{"solve", sand, "--law", "power:NUMBER"},
           Arguments{"solve", sand, "--tolerance", "NUMBER%"},
           Arguments{"solve", sand, "--tolerance", "total:NUMBER", "--node-limit", "NUMBER"},
           Arguments{"solve", sand, "--tolerance", "1", "--time-limit", "NUMBER", "--gap", "NUMBER"},
           Arguments{"solve", sand, "--particles", "NUMBER", "--grid", "NUMBER"},
           Arguments{"solve", sand, "--round", "NUMBER"},
           Arguments{"solve", sand, "--spread", "--seed", "NUMBER"},
           Arguments{"convert", title, "--skip", "NUMBER"},
           Arguments{"batch", lines, "-j", "NUMBER"},
           Arguments{"tradeoff", sand, "--tolerances", "0,NUMBER", "--particles", "NUMBER"},
           Arguments{"describe", sand, "--digits", "NUMBER"},
           Arguments{"describe", sand, "--liquid-limit", "NUMBER", "--plastic-limit", "NUMBER"},
           Arguments{"judge", sand, "--spec", "superpave-9.5", "--rounding", "NUMBER", "--digits", "NUMBER"},
           Arguments{"verify", sand, sample, "--digits", "NUMBER"},
           Arguments{"published", "fixed-size", sand, "--tolerance", "NUMBER%", "--digits", "NUMBER"},
           Arguments{"export", sand, "--to", "diameters", "--size-factor", "NUMBER"},
           Arguments{"suite", "-", "--count", "NUMBER", "--seed", "NUMBER", "-j", "NUMBER"},
           Arguments{"suite", "-", "--lines", "NUMBER-NUMBER"},
           Arguments{"suite", "-", "--shard", "NUMBER/NUMBER"},
           Arguments{"generate", "--beta", "NUMBER,NUMBER", "--dmin", "NUMBERum", "--ratio", "NUMBER",
                     "--classes", "NUMBER", "--at-least", "NUMBER", "--min-per-class", "NUMBER", "--points",
                     "NUMBER", "--digits", "NUMBER"},
           Arguments{"generate", "--accessible", "--span", "0.5", "--a", "NUMBER,2", "--b",
                     "NUMBER:NUMBER:NUMBER", "--at-most", "3000", "-j", "NUMBER"},
           Arguments{"pack", "--apollonian", "equal", "--smallest", "1/NUMBER", "-o", "-"},
       }) {
    ++turn;
    const Outcome plain = with_number(arguments, "10");
    INFO(arguments[0] << " " << arguments[arguments.size() - 2] << ": " << plain.err);
    CHECK(plain.exit_code != 2);
    for (const char *number : {"1e1", "1_0", "1_0.0"}) {
      if (!takes_all_cases() && ++turn % 2 == 0)
        continue;
      const Outcome same = with_number(arguments, number);
      INFO(number << ": " << same.err);
      CHECK(same.exit_code == plain.exit_code);
      if (arguments[0] != "export" && arguments[0] != "suite") // which repeat the words of the command
        CHECK(same.out == plain.out);
    }
    for (const char *wrong : {"1__0", "_10", "10_", "1e", "ten", "1 0", "0x10"})
      if (takes_all_cases() || ++turn % 2 == 0)
        check_refused(with_number(arguments, wrong));
  }
}

TEST_CASE("a whole number may not be a fraction or negative", "[cli]") {
  for (const char *option : {"--at-least", "--at-most", "--min-per-class", "--max-steps"})
    for (const char *number : {"1.5", "-1", "1e-1", "-1e4"})
      check_refused(mdm({"solve", sand, option, number}), option);
  check_refused(mdm({"batch", sand, "-j", "1e4"}), "-j: '1e4' is not a whole number from 1 to 1024");
}

} // namespace number_options_test
