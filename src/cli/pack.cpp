#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/pack_apollonian.hpp"
#include "cli/pack_sizes.hpp"
#include "cli/progress.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "packing/deposit.hpp"
#include "packing/packing_writer.hpp"
#include "report/packing_report.hpp"

#include <fmt/core.h>

#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

struct PackCommand {
  PackSizes sizes;
  ApollonianFlags apollonian;
  std::optional<std::string> width;
  std::string floor = "centred", rule = "lowest", order = "shuffled", seed = "1";
  bool periodic = false, walls = false, positions = false;
  OutputFlags output;
};

/// \param unit  of the discs; empty: any
Rational width_in(const std::string &unit, const Length &width) {
  const std::optional<LengthUnit> of_discs = parse_length_unit(unit);
  if (width.unit && !of_discs)
    throw InputError("--width: the discs have no unit: write the number alone");
  return width.unit ? Rational(width.value * in_mm(*width.unit) / in_mm(*of_discs)) : width.value;
}

DepositOptions deposit_options(const PackCommand &c) {
  if (c.periodic && c.walls)
    throw InputError("--periodic and --walls exclude each other");
  DepositOptions o;
  o.rule = c.rule == "drop" ? DepositRule::drop : DepositRule::lowest;
  o.floor = c.floor == "left" ? FloorRule::left : FloorRule::centred;
  o.periodic = !c.walls;
  o.seed = seed64("seed", c.seed);
  o.shuffled = c.order == "shuffled";
  return o;
}

Packing packed(const PackCommand &c) {
  DepositOptions options = deposit_options(c);
  std::atomic<std::size_t> lying = 0;
  options.progress = [&lying](std::size_t n) { lying = n; };
  const Progress progress([&lying] { return fmt::format("packing, {} discs lie", lying.load()); },
                          c.output.quiet);
  const std::optional<Length> width = c.width ? std::optional(length("width", *c.width)) : std::nullopt;
  const DiscSizes discs = c.sizes.read(options.seed);
  c.output.tell_notes(discs.notes);
  if (width)
    options.width = width_in(discs.unit, *width);
  return deposit(discs, options);
}

void report(const PackCommand &c, const Packing &packing) {
  const PackingTexture texture = packing_texture(packing);
  Output out("-");
  const Sink sink = [&out](std::string_view text) { out.write(text); };
  if (c.output.is_json()) {
    packing_json(packing, texture, {c.positions}, sink);
    sink("\n");
  } else {
    sink(c.output.is_csv() ? packing_csv(packing, texture) : packing_text(packing, texture));
  }
  out.commit();
}

int run(const PackCommand &c) {
  if (c.apollonian.gasket) {
    if (c.sizes.is_given() || c.width || c.positions)
      throw InputError("--apollonian has its own sizes and places: leave out those of a deposit");
    return run_apollonian(c.apollonian, c.output);
  }
  if (c.apollonian.smallest || c.apollonian.count_only)
    throw InputError("--smallest and --count-only are of --apollonian: add it or leave them out");
  if (c.positions && !c.output.is_json())
    throw InputError("--positions: they are in the file of -o; in the report only with --format json");
  check_distinct({c.sizes.source(), c.output.path()});
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
  c->sizes.add_to(command);
  c->apollonian.add_to(command);
  const auto option = [&command](const char *name, auto &value, const char *type, const char *help) {
    return command.add_option(name, value, help)->type_name(type);
  };
  option("--width", c->width, "W",
         "of the box, 3 of the largest discs or more (as wide as the packing is high)");
  command.add_flag("--periodic", c->periodic, "the box repeats itself to both sides (the default)");
  command.add_flag("--walls", c->walls, "the box has walls");
  option("--floor", c->floor, "TEXT",
         "a disc for which the floor is bare goes to the left end of the first bare "
         "piece (left), or to its middle (centred, the default)")
      ->check(CLI::IsMember({"left", "centred"}));
  option("--rule", c->rule, "TEXT",
         "each disc goes to the lowest place that is reached from above (lowest, the default), or is dropped "
         "in a "
         "random column and rolls to rest (drop)")
      ->check(CLI::IsMember({"lowest", "drop"}));
  option("--order", c->order, "TEXT", "of the discs: shuffled by --seed (the default), or as given")
      ->check(CLI::IsMember({"shuffled", "given"}));
  option("--seed", c->seed, "K", "of drawn sizes, of the order and of random columns (1)");
  c->output.out_has_report = false;
  c->output.check_ending_of_out(command, {"packing", "txt"});
  c->output.add_format(command, "of the report: text, json or csv");
  command.add_flag("--positions", c->positions, "with --format json: centre and radius of every disc");
  option("-o", c->output.out, "OUT",
         "write the packing to OUT: a header, then x y r left right of each disc; - for standard "
         "output, without the report");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  command.footer(footer("", {"mdm pack --beta 1,1 --span 0.97 --at-least 25000 --seed 1 -o start.packing",
                             "mdm pack sand.csv --spread --seed 1 --walls --rule drop",
                             "mdm pack --apollonian -1,2,2,3 --smallest 1/1000"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
