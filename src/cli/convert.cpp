#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"

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

/// What was understood of the file, with the table that would be written.
std::string understood_text(const ConvertCommand &c, const UnderstoodGradation &u) {
  const Gradation &g = u.gradation;
  std::string text = printable(shown_name(c.file)) + ": " + u.format + "\n";
  text += "  id      " + printable(g.id()) + "\n";
  text += "  sizes   " + u.sizes + "\n";
  text += "  masses  " + u.masses + "\n";
  text += std::string("  pan     ") + (g.has_pan() ? "yes, at size 0" : "none") + "\n";
  text += std::string("  check   ") +
          (u.is_canonical ? "mdm-check reads the file as it is" : "mdm-check reads what mdm convert writes") +
          "\n";
  for (const std::string &sample : u.samples)
    text += "  sample  " + printable(sample) + "\n";
  for (const std::string &note : g.notes())
    text += "  note    " + note + "\n";
  return text + "\n" + gradation_csv(g);
}

std::string converted(const ConvertCommand &c, const UnderstoodGradation &u) {
  if (c.dry_run)
    return understood_text(c, u);
  return c.output.is_json() ? gradation_json(u.gradation) : gradation_csv(u.gradation);
}

int run(const ConvertCommand &c) {
  if (c.dry_run && (c.output.out || c.output.asked_format))
    throw InputError("--dry-run: nothing is converted: leave out -o and --format");
  check_distinct({c.file, c.output.path()});
  const UnderstoodGradation u = any_gradation(c.file, c.reading, c.output.quiet, PhiReading::rounded);
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
  c->output.add_out(command);
  command.add_option("--format", c->output.asked_format, "csv or json; json if OUT ends so, else csv")
      ->check(CLI::IsMember({"csv", "json"}));
  command.add_flag("--dry-run", c->dry_run,
                   "show what was understood: the table, its unit and kind, pan and notes");
  c->output.add_quiet(command, "no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer("", {"mdm convert report.ags --specimen-id BH1 -o sand.csv",
                             "mdm convert sieving.xlsx --sheet Sand --dry-run",
                             "mdm convert half-phi.csv --format csv | mdm solve - --tolerance retained:1%"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
