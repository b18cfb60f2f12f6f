#include "ask/pack.hpp"

#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/pack_apollonian.hpp"
#include "cli/reading_flags.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/packing_file.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "packing/deposit.hpp"
#include "packing/packing_writer.hpp"
#include "report/packing_report.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

struct PackCommand {
  PackTexts asked;
  ReadingFlags reading;
  OutputFlags output;
};

std::string read_discs(const std::string &path) {
  return read_file(path, most_packing_bytes);
}

Packing packed(const PackCommand &c) {
  DepositOptions options = c.asked.deposit_options();
  std::atomic<std::size_t> lying = 0;
  options.progress = [&lying](std::size_t n) { lying = n; };
  const ProgressLine progress([&lying] { return fmt::format("packing, {} discs lie", lying.load()); },
                              c.output.quiet);
  const DiscSizes discs = c.asked.discs(read_discs);
  c.output.tell_notes(discs.notes);
  options.width = c.asked.width_in(discs.unit);
  return deposit(discs, options);
}

void report(const PackCommand &c, const Packing &packing) {
  const PackingTexture texture = packing_texture(packing);
  Output out("-");
  const Sink sink = [&out](std::string_view text) { out.write(text); };
  if (c.output.is_json()) {
    packing_json(packing, texture, {c.asked.positions}, sink);
    sink("\n");
  } else {
    sink(c.output.is_csv() ? packing_csv(packing, texture) : packing_text(packing, texture));
  }
  out.commit();
}

int run(const PackCommand &command) {
  PackCommand c = command;
  c.asked.reading = command.reading;
  if (c.asked.gasket) {
    if (c.asked.are_discs_given() || c.asked.are_places_given())
      throw InputError(option("apollonian") + " has its own sizes and places: leave out those of a deposit");
    return run_apollonian(c.asked, c.output);
  }
  if (c.asked.smallest || c.asked.count_only)
    throw InputError(option("smallest") + " and " + option("count-only") + " are of " + option("apollonian") +
                     ": add it or leave them out");
  if (c.asked.positions && !c.output.is_json())
    throw InputError(option("positions") + ": they are in the file of -o; in the report only with " +
                     option("format") + " json");
  check_distinct({c.asked.source(), c.output.path()});
  const Packing packing = packed(c);
  if (c.output.out) {
    Output out(*c.output.out);
    write_packing(packing, [&out](std::string_view text) { out.write(text); });
    out.commit();
  }
  if (c.output.out != "-")
    report(c, packing);
  return Exit::done;
}

} // namespace

Run add_pack(CLI::App &app) {
  const auto c = std::make_shared<PackCommand>();
  CLI::App &command =
      *app.add_subcommand("pack", "A packing of discs: deposited one after the other, or Apollonian");
  command.add_option(
      "FILE", c->asked.file,
      "sizes that mdm generate --sizes wrote (CSV or JSON), or with --spread a gradation of discs "
      "(CSV, JSON, AGS4); - for standard input");
  add_options(command, PackTexts::disc_options, c->asked);
  c->reading.add_to(command);
  add_options(command, PackTexts::gasket_options, c->asked);
  add_options(command, PackTexts::place_options, c->asked);
  c->output.out_has_report = false;
  c->output.check_ending_of_out(command, {"packing", "txt"});
  c->output.add_format(command, "of the report: text, json or csv");
  add_options(command, PackTexts::answer_options, c->asked);
  command
      .add_option("-o", c->output.out,
                  "write the packing to OUT: a header, then x y r left right of each disc; - for standard "
                  "output, without the report")
      ->type_name("OUT");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  command.footer(footer("", {"mdm pack --beta 1,1 --span 0.97 --at-least 25000 --seed 1 -o start.packing",
                             "mdm pack sand.csv --spread --seed 1 --walls --rule drop",
                             "mdm pack --apollonian -1,2,2,3 --smallest 1/1000"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
