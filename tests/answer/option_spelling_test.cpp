#include "answer/generated_reader.hpp"
#include "spellings.hpp"

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("The note of a set of discs names the law in the spelling of the front end") {
  StatedSet set;
  set.dimension = 2;
  set.classes.push_back({1, 2, 1, false, std::nullopt});
  const auto note = [&set] { return set_gradation(set).notes().back(); };
  check_spellings(note, {": --law power:2 where", ": law power:2 where", ": law power:2 where"});
}

} // namespace option_spelling_test
