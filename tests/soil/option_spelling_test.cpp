#include "soil.hpp"
#include "soil/describe.hpp"
#include "spellings.hpp"

#include <fmt/format.h>

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("The notes of a soil name options in the spelling of the front end") {
  const auto notes = [](const std::vector<std::pair<std::string, std::string>> &points) {
    return [points] {
      return fmt::format("{}", fmt::join(describe(grading_test::soil(points), {}).notes, "\n"));
    };
  };
  check_spellings(notes({{"0", "0"}, {"0.075", "60"}, {"2", "100"}}),
                  {"(--extrapolate continues the curve, --pan-size gives",
                   "(extrapolate continues the curve, pan_size gives",
                   "(extrapolate continues the curve, panSize gives"});
  check_spellings(notes({{"0.001", "0"}, {"0.075", "60"}, {"2", "100"}}),
                  {"; --liquid-limit and --plastic-limit classify",
                   "; liquid_limit and plastic_limit classify", "; liquidLimit and plasticLimit classify"});
}

} // namespace option_spelling_test
