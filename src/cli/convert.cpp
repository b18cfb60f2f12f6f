#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct ConvertCommand {
  std::string file;
  std::optional<std::string> specimen_id;
  OutputFlags output;
};

int run(const ConvertCommand &c) {
  check_distinct({c.file, c.output.path()});
  const std::string content = read_file(c.file, max_gradation_bytes);
  const Gradation g = read_gradation(content, shown_name(c.file), c.specimen_id, PhiReading::rounded);
  Output out(c.output.path());
  out.write(in_file(c.file, [&] { return c.output.is_json() ? gradation_json(g) : gradation_csv(g); }));
  out.commit();
  c.output.tell_notes(g.notes());
  return Exit::done;
}

} // namespace

Run add_convert(CLI::App &app) {
  const auto c = std::make_shared<ConvertCommand>();
  CLI::App &command = *app.add_subcommand("convert", "Any gradation file as canonical CSV or JSON");
  command.add_option("FILE", c->file, "gradation: CSV, JSON or AGS4; - for standard input")->required();
  c->output.add_out(command);
  command.add_option("--format", c->output.asked_format, "csv or json; json if OUT ends so, else csv")
      ->check(CLI::IsMember({"csv", "json"}));
  add_specimen_id(command, c->specimen_id);
  c->output.add_quiet(command, "no notes on standard error");
  command.footer(footer("", {"mdm convert report.ags --specimen-id BH1 -o sand.csv",
                             "mdm convert half-phi.csv --format csv | mdm solve - --tolerance retained:1%",
                             "mdm convert sand.csv -o sand.json"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
