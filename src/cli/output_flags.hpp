#pragma once
/// \file
/// The options that commands have in common, and what they do with them.

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mdm::cli {

/// How, where and how loudly a command answers: --format, -o and --quiet. The help names what is written.
struct OutputFlags {
  std::optional<std::string> asked_format;
  bool out_has_report = true; ///< the ending of -o tells the format where --format does not
  std::optional<std::string> out;
  bool quiet = false, verbose = false;

  void add_format(CLI::App &command,
                  const std::string &help = "text, json or csv; else as OUT ends, else text");
  /// \param help completed by "to OUT instead of standard output"
  CLI::Option *add_out(CLI::App &command, const std::string &help = "write",
                       const std::vector<std::string> &endings = {"txt", "json", "csv"});
  /// Refuses, when all options are known, an OUT that ends as another format does; --format says what it
  /// holds.
  void check_ending_of_out(CLI::App &command, const std::vector<std::string> &endings);
  void add_quiet(CLI::App &command, const std::string &help);
  void add_verbose(CLI::App &command, const std::string &help);

  /// text, json or csv.
  std::string format() const;
  bool is_text() const { return format() == "text"; }
  bool is_json() const { return format() == "json"; }
  bool is_csv() const { return format() == "csv"; }
  /// `-` for standard output.
  std::string path() const { return out.value_or("-"); }
  /// The report in the form that was asked for; the functions make it.
  template <class Text, class Json, class Csv>
  std::string report(Text text, Json json, Csv csv) const {
    return is_json() ? json() + "\n" : is_csv() ? csv() : text();
  }
  /// Shows notes on standard error, unless --quiet.
  void tell_notes(const std::vector<std::string> &notes) const;
  /// Shows them where the report is CSV, which has no place for them.
  void tell_notes_beside_csv(const std::vector<std::string> &notes) const;
};

} // namespace mdm::cli
