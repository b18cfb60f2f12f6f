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

} // namespace file_names_test
