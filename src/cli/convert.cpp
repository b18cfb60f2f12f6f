#include "commands.hpp"
#include "files.hpp"
#include "option_values.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct ConvertCommand {
  std::string file;
  std::optional<std::string> specimen_id, format;
  std::string out = "-";
  bool quiet = false;
};

bool ends_with_json(const std::string &path) {
  return path.size() >= 5 && path.compare(path.size() - 5, 5, ".json") == 0;
}

int run(const ConvertCommand &c) {
  check_distinct({c.file, c.out});
  const std::string content = read_file(c.file, max_gradation_bytes);
  const Gradation g = read_gradation(content, shown_name(c.file), c.specimen_id);
  const bool json = c.format ? *c.format == "json" : ends_with_json(c.out);
  Output out(c.out);
  out.write(named(printable(shown_name(c.file)), "",
                  [&](const std::string &) { return json ? gradation_json(g) : gradation_csv(g); }));
  out.commit();
  for (const std::string &note : g.notes())
    if (!c.quiet)
      tell("note: " + note + "\n");
  return Exit::done;
}

} // namespace

Run add_convert(CLI::App &app) {
  const auto c = std::make_shared<ConvertCommand>();
  CLI::App &command = *app.add_subcommand("convert", "Any gradation file as canonical CSV or JSON");
  command.add_option("FILE", c->file, "gradation: CSV, JSON or AGS4; - for standard input")->required();
  command.add_option("-o", c->out, "write to OUT instead of standard output")->type_name("OUT");
  command.add_option("--format", c->format, "csv or json; json if OUT ends so, else csv")
      ->check(CLI::IsMember({"csv", "json"}));
  command.add_option("--specimen-id", c->specimen_id, "the specimen of an AGS4 file with several")
      ->type_name("ID");
  command.add_flag("--quiet", c->quiet, "no notes on standard error");
  command.footer("Example: mdm convert report.ags --specimen-id BH1 -o sand.csv");
  return [c] { return run(*c); };
}

} // namespace mdm::cli
