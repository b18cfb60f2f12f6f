#include "catch.hpp"
#include "text/filesystem_path.hpp"

namespace filesystem_path_test {

using namespace mdm;

TEST_CASE("a path has the letters of its name") {
  const std::filesystem::path path = filesystem_path("Länge und Breite/Größe.csv");
  CHECK(path.filename() == u8"Größe.csv");
  CHECK(path_name(path.parent_path()) == "Länge und Breite");
}

TEST_CASE("a name that is no UTF-8 keeps its bytes") {
  const std::string name = "sand\xff.csv";
  CHECK(filesystem_path(name).native() == name);
  CHECK(path_name(filesystem_path(name)) == name);
}

} // namespace filesystem_path_test
