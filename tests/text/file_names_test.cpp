#include "catch.hpp"
#include "text/file_names.hpp"

namespace file_names_test {

using namespace mdm;

TEST_CASE("the name of a file begins behind its folders") {
  CHECK(name_begin("sand.csv") == 0);
  CHECK(name_begin("a/b/sand.csv") == 4);
  CHECK(name_begin("/") == 1);
  CHECK(name_begin("") == 0);
}

TEST_CASE("a path in a command is a word that is no option") {
  CHECK(shell_word("a/b-1.csv") == "a/b-1.csv");
  CHECK(shell_word("a b.csv") == "'a b.csv'");
  CHECK(shell_word("-x.csv") == "./-x.csv");
  CHECK(shell_word("-a b.csv") == "'./-a b.csv'");
  CHECK(shell_word("-") == "-");
}

} // namespace file_names_test
