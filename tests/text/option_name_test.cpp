#include "../gradation/support.hpp"
#include "text/option_name.hpp"

namespace option_name_test {

using namespace mdm;

TEST_CASE("An option is spelled as the front end spells it") {
  CHECK(option("contact-gap") == "--contact-gap");
  spell_options(OptionSpelling::keyword);
  CHECK(option("contact-gap") == "contact_gap");
  CHECK(option("law") == "law");
  CHECK(option("from") == "from_format"); // `from` is a word of Python
  CHECK(option("from-grid") == "from_grid");
  spell_options(OptionSpelling::member);
  CHECK(option("contact-gap") == "contactGap");
  CHECK(option("min-per-class") == "minPerClass");
  CHECK(option("from") == "from");
  spell_options(OptionSpelling::program);
  CHECK(option("law") == "--law");
}

} // namespace option_name_test
