#include "crosscheck/program_text.hpp"

#include <algorithm>

namespace mdm {

std::string_view name(ProgramLanguage language) {
  switch (language) {
  case ProgramLanguage::lp:
    return "lp";
  case ProgramLanguage::mps:
    return "mps";
  case ProgramLanguage::smt2:
    return "smt2";
  case ProgramLanguage::mzn:
    return "mzn";
  case ProgramLanguage::opb:
    return "opb";
  default:
    return "json";
  }
}

std::optional<ProgramLanguage> program_language_named(std::string_view text) {
  const auto *const found = std::find_if(program_languages.begin(), program_languages.end(),
                                         [&](ProgramLanguage l) { return name(l) == text; });
  return found == program_languages.end() ? std::nullopt : std::optional(*found);
}

ProgramForm form_of(ProgramLanguage language) {
  switch (language) {
  case ProgramLanguage::smt2:
  case ProgramLanguage::json:
    return ProgramForm::strict;
  case ProgramLanguage::mzn:
  case ProgramLanguage::opb:
    return ProgramForm::integers;
  default:
    return ProgramForm::stepped;
  }
}

std::string program_text(const IntegerProgram &program, ProgramLanguage language) {
  switch (language) {
  case ProgramLanguage::lp:
    return lp_text(program);
  case ProgramLanguage::mps:
    return mps_text(program);
  case ProgramLanguage::smt2:
    return smt2_text(program);
  case ProgramLanguage::mzn:
    return minizinc_text(program);
  case ProgramLanguage::opb:
    return pseudo_boolean_text(program);
  default:
    return program_json(program) + "\n";
  }
}

std::string comment_lines(const IntegerProgram &program, std::string_view mark) {
  std::string text;
  for (const std::string &comment : program.comments)
    text.append(mark).append(" ").append(comment).append("\n");
  return text;
}

} // namespace mdm
