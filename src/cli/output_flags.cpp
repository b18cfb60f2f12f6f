#include "cli/output_flags.hpp"

#include "cli/files.hpp"

namespace mdm::cli {

void OutputFlags::add_format(CLI::App &command, const std::string &help) {
  command.add_option("--format", asked_format, help)->check(CLI::IsMember({"text", "json", "csv"}));
}

CLI::Option *OutputFlags::add_out(CLI::App &command, const std::string &help) {
  return command.add_option("-o", out, help + " to OUT instead of standard output")->type_name("OUT");
}

void OutputFlags::add_quiet(CLI::App &command, const std::string &help) {
  command.add_flag("--quiet", quiet, help);
}

std::string OutputFlags::format() const {
  if (asked_format)
    return *asked_format;
  std::string ending = out_has_report ? path() : "";
  if (names_zstd(ending))
    ending.resize(ending.rfind('.'));
  return ending.ends_with(".json") ? "json" : ending.ends_with(".csv") ? "csv" : "text";
}

void OutputFlags::tell_notes(const std::vector<std::string> &notes) const {
  if (!quiet)
    for (const std::string &note : notes)
      tell("note: " + note + "\n");
}

void OutputFlags::tell_notes_beside_csv(const std::vector<std::string> &notes) const {
  if (is_csv())
    tell_notes(notes);
}

} // namespace mdm::cli
