#include "ask/inverse.hpp"
#include "cli/accessible.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/inverse.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/standard_streams.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <fmt/core.h>

#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

struct GenerateCommand : GenerateTexts {
  ReadingFlags reading_flags;
  OutputFlags output;
  AccessibleFlags accessible_flags;

  GenerateTexts asked() const {
    GenerateTexts texts = *this;
    texts.reading = reading_flags;
    texts.format = output.format();
    return texts;
  }
};

std::string read_curve(const std::string &path) {
  return read_file(path, max_gradation_bytes);
}

int run(const GenerateCommand &c) {
  const GenerateTexts asked = c.asked();
  if (asks_for_shapes(asked)) {
    check_distinct({c.fit.value_or("-"), c.output.path()});
    return run_inverse(inverse_task(asked, read_curve), c.output, c.accessible_flags);
  }
  if (!c.accessible && (c.a || c.b || c.accessible_flags.is_given()))
    throw InputError(option("a") + ", " + option("b") + ", " + option("plot") + " and -j are of " +
                     option("accessible") + ", " + option("plot") + " and -j of " + option("cu") + " and " +
                     option("fit") + ", too: add one or leave them out");
  if (c.accessible)
    return run_accessible(accessible_question(asked), c.output, c.accessible_flags);
  check_generate(asked);
  check_distinct({c.curve.value_or("-"), c.output.path()});
  const std::optional<Draws> how = asked.writes_sizes() ? std::optional(draws_of(asked)) : std::nullopt;
  std::atomic<std::uint64_t> written = 0;
  ProgressLine progress([&written] { return fmt::format("generating, {} MB written", written / 1000000); },
                        c.output.quiet);
  const GeneratedSet set = generated(asked, read_curve);
  if (how && set.particles())
    check_listed(set, *set.particles());
  Output out(c.output.path());
  const Sink sink = [&](std::string_view text) {
    out.write(text);
    written += text.size();
  };
  if (c.output.is_json()) {
    generated_json(set, how, sink);
    out.write("\n");
  } else if (c.output.is_csv()) {
    generated_csv(set, how, sink);
  } else {
    out.write(generated_text(set));
  }
  out.commit();
  const int code = exit_code(outcome_of(set));
  // CSV has no place for them.
  if (c.output.is_csv() && code != Exit::done)
    tell(printable(set.id) + ": " + headline(set) + "\n");
  c.output.tell_notes_beside_csv(set.notes);
  return code;
}

} // namespace

Run add_generate(CLI::App &app) {
  const auto c = std::make_shared<GenerateCommand>();
  CLI::App &command =
      *app.add_subcommand("generate", "A representative set of particles from a grading curve");
  add_options(command, GenerateTexts::options, *c);
  add_options(command, GenerateTexts::accessible_options, *c);
  add_options(command, GenerateTexts::inverse_options, *c);
  c->accessible_flags.add_to(command);
  add_options(command, GenerateTexts::answer_options, *c);
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading_flags.add_to(command);
  command.footer(footer("", {"mdm generate --beta 1,3 --dmin 0.1 --ratio 20 --sizes --seed 1 --format csv",
                             "mdm generate --curve sand.csv --method match --spread -o set.json",
                             "mdm generate --accessible --span 0.42,0.97 --plot shapes.svg",
                             "mdm generate --cu 6 --cc 1.2 --span 0.95"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
