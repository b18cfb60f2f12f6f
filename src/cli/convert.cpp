#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "report/reading_report.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct ConvertCommand {
  std::string file;
  ReadingFlags reading;
  OutputFlags output;
  bool dry_run = false;
};

std::string converted(const ConvertCommand &c, const UnderstoodGradation &u) {
  if (c.dry_run && c.output.is_json())
    return reading_json(u) + "\n";
  if (c.dry_run)
    return reading_text(u, printable(shown_name(c.file))) + "\n" + gradation_csv(u.gradation);
  return c.output.is_json() ? gradation_json(u.gradation) : gradation_csv(u.gradation);
}

int run(const ConvertCommand &c) {
  if (c.dry_run && !c.output.is_json() && (c.output.out || c.output.asked_format))
    throw InputError(option("dry-run") + ": nothing is converted: leave out -o and " + option("format") +
                     ", or ask for what was "
                     "understood with " +
                     option("format") + " json");
  check_distinct({c.file, c.output.path()});
  const bool writes_sizes = !(c.dry_run && c.output.is_json());
  const UnderstoodGradation u = any_gradation(c.file, c.reading, c.output.quiet,
                                              writes_sizes ? PhiReading::rounded : PhiReading::exact);
  Output out(c.output.path());
  out.write(in_file(c.file, [&] { return converted(c, u); }));
  out.commit();
  if (!c.dry_run)
    c.output.tell_notes(u.gradation.notes());
  return Exit::done;
}

} // namespace

Run add_convert(CLI::App &app) {
  const auto c = std::make_shared<ConvertCommand>();
  CLI::App &command = *app.add_subcommand("convert", "Any gradation file as canonical CSV or JSON");
  command
      .add_option("FILE", c->file,
                  "gradation: CSV, JSON, AGS4, DIGGS, a table or workbook of a laboratory, a file of an "
                  "instrument; or a set of mdm generate or file of particles, whose gradation it is; - for "
                  "standard input")
      ->required();
  c->output.add_out(command, "write", {"csv", "txt", "json"});
  command.add_option("--format", c->output.asked_format, "csv or json; json if OUT ends so, else csv")
      ->check(CLI::IsMember({"csv", "json"}));
  command.add_flag("--dry-run", c->dry_run,
                   "show what was understood: the table, its unit and kind, pan and notes; also as JSON");
  c->output.add_quiet(command, "no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer("", {"mdm convert report.ags --specimen-id BH1 -o sand.csv",
                             "mdm convert sieving.xlsx --sheet Sand --dry-run",
                             "mdm convert half-phi.csv --format csv | mdm solve - --tolerance retained:1%"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
