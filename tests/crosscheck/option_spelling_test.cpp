#include "crosscheck/answer_index.hpp"
#include "crosscheck/other_answer.hpp"
#include "spellings.hpp"

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("The note of ids with several answers names the option in the spelling of the front end") {
  const auto note = [] {
    const AnswerIndex index(read_answers("id,quantities,knob\na,1,x\na,2,y\n", "answers.csv"));
    return index.notes().back();
  };
  check_spellings(note, {"tell them apart with --by, by 'knob'", "tell them apart with by, by 'knob'",
                         "tell them apart with by, by 'knob'"});
}

} // namespace option_spelling_test
