#include "crosscheck/program_text.hpp"

#include <algorithm>
#include <array>

namespace mdm {

namespace {

struct Language {
  std::string_view name;
  ProgramForm form;
  std::string (*text)(const IntegerProgram &);
};

std::string json_line(const IntegerProgram &program) {
  return program_json(program) + "\n";
}

/// In the order of ProgramLanguage.
constexpr std::array<Language, 6> languages = {{
    {"lp", ProgramForm::stepped, lp_text},
    {"mps", ProgramForm::stepped, mps_text},
    {"smt2", ProgramForm::strict, smt2_text},
    {"mzn", ProgramForm::integers, minizinc_text},
    {"opb", ProgramForm::integers, pseudo_boolean_text},
    {"json", ProgramForm::strict, json_line},
}};

const Language &row_of(ProgramLanguage language) {
  return languages.at(static_cast<std::size_t>(language));
}

} // namespace

std::vector<std::string> program_language_names() {
  std::vector<std::string> names;
  for (const Language &language : languages)
    names.emplace_back(language.name);
  return names;
}

std::optional<ProgramLanguage> program_language_named(std::string_view name) {
  const auto *const found = std::find_if(languages.begin(), languages.end(),
                                         [&](const Language &language) { return language.name == name; });
  return found == languages.end() ? std::nullopt
                                  : std::optional(static_cast<ProgramLanguage>(found - languages.begin()));
}

ProgramForm form_of(ProgramLanguage language) {
  return row_of(language).form;
}

std::string program_text(const IntegerProgram &program, ProgramLanguage language) {
  return row_of(language).text(program);
}

std::string comment_lines(const IntegerProgram &program, std::string_view mark) {
  std::string text;
  for (const std::string &comment : program.comments)
    text.append(mark).append(" ").append(comment).append("\n");
  return text;
}

} // namespace mdm
