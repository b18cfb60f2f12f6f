#include "cli/output_flags.hpp"

#include "files/file_ending.hpp"
#include "files/standard_streams.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

namespace mdm::cli {

void OutputFlags::add_format(CLI::App &command, const std::string &help) {
  command.add_option("--format", asked_format, help)->check(CLI::IsMember({"text", "json", "csv"}));
}

CLI::Option *OutputFlags::add_out(CLI::App &command, const std::string &help,
                                  const std::vector<std::string> &endings) {
  check_ending_of_out(command, endings);
  return command.add_option("-o", out, help + " to OUT instead of standard output")->type_name("OUT");
}

void OutputFlags::check_ending_of_out(CLI::App &command, const std::vector<std::string> &endings) {
  command.callback([this, &command, endings] {
    const bool has_format = command.get_option_no_throw("--format") != nullptr;
    if (out && !(asked_format && out_has_report))
      check_ending(*out, endings, command.get_name(),
                   has_format && out_has_report ? ", or say with " + option("format") + " what it holds"
                                                : "");
  });
}

void OutputFlags::add_quiet(CLI::App &command, const std::string &help) {
  command.add_flag("--quiet", quiet, help);
}

void OutputFlags::add_verbose(CLI::App &command, const std::string &help) {
  command.add_flag("--verbose", verbose, help);
}

std::string OutputFlags::format() const {
  if (asked_format)
    return *asked_format;
  const std::string ending = out_has_report ? ending_of(path()) : "";
  return ending == "json" || ending == "csv" ? ending : "text";
}

void OutputFlags::tell_notes(const std::vector<std::string> &notes) const {
  if (!quiet)
    for (const std::string &note : notes)
      tell("note: " + printable(note) + "\n");
}

void OutputFlags::tell_notes_beside_csv(const std::vector<std::string> &notes) const {
  if (is_csv())
    tell_notes(notes);
}

} // namespace mdm::cli
