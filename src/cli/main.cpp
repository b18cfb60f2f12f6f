#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/solve_flags.hpp"
#include "cli/usage_error.hpp"
#include "files/number_pool.hpp"
#include "files/output.hpp"
#include "files/standard_streams.hpp"
#include "text/option_name.hpp"
#include "text/versions.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#ifdef MDM_HAS_ZLIB
#include <zlib.h>
#endif
#ifdef MDM_HAS_ZSTD
#include <zstd.h>
#endif
#ifdef MDM_HAS_LIBCRYPTO
#include <openssl/opensslv.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace mdm;
using namespace mdm::cli;

/// A command and what runs it.
struct Command {
  CLI::App *app;
  Run run;
};

std::string version_text() {
  std::string text;
  for (const auto &[library, version] : mdm::versions())
    text += library + " " + version + "\n";
#ifdef MDM_HAS_ZSTD
  text += "zstd " ZSTD_VERSION_STRING "\n";
#endif
#ifdef MDM_HAS_ZLIB
  text += "zlib " ZLIB_VERSION "\n";
#endif
#ifdef MDM_HAS_LIBCRYPTO
  text += "libcrypto " OPENSSL_VERSION_STR "\n";
#endif
  return text + "cli11 " CLI11_VERSION;
}

void print(const std::string &text) {
  Output out("-");
  out.write(text);
  out.commit();
}

int complain(const std::string &message) {
  tell(message + "\n");
  return Exit::bad_input;
}

std::vector<Command> add_commands(CLI::App &app) {
  std::vector<Command> commands;
  for (Run (*const add)(CLI::App &) :
       {add_solve, add_batch, add_merge, add_convert, add_describe, add_judge, add_report, add_verify,
        add_crosscheck, add_published, add_generate, add_blend, add_suite, add_pack, add_study, add_tradeoff,
        add_plot, add_export, add_completion}) {
    Run run = add(app);
    commands.push_back({app.get_subcommands({}).back(), std::move(run)});
  }
  std::vector<CLI::App *> all = app.get_subcommands({});
  all.push_back(&app);
  for (CLI::App *const a : all) {
    a->set_help_flag("-h,--help", "show this help")->group("Help");
    a->set_version_flag("-V,--version", version_text(), "show the versions of the program and its libraries")
        ->group("Help");
  }
  return commands;
}

std::vector<std::string> names(const std::vector<Command> &commands) {
  std::vector<std::string> all;
  for (const Command &c : commands)
    all.push_back(c.app->get_name());
  return all;
}

std::string no_command(const std::string &word, const std::vector<Command> &commands) {
  return fmt::format("mdm: {} is no command{}; there are {}", mdm::in_quotes(word),
                     did_you_mean(word, names(commands)), fmt::join(names(commands), ", "));
}

/// The arguments with `help COMMAND` as `COMMAND --help`.
std::vector<std::string> arguments(int argc, char **argv) {
  std::vector<std::string> all(argv + 1, argv + argc);
  if (!all.empty() && all.front() == "help") {
    all.erase(all.begin());
    all.emplace_back("--help");
  }
  return all;
}

/// Who runs this program for Python or JavaScript says so by MDM_OPTION_SPELLING, keyword or member: messages
/// then name options as these languages do.
void spell_options_as_asked() {
  const char *const asked = std::getenv("MDM_OPTION_SPELLING");
  const std::string_view spelling = asked == nullptr ? "" : asked;
  if (spelling == "keyword")
    spell_options(OptionSpelling::keyword);
  else if (spelling == "member")
    spell_options(OptionSpelling::member);
}

int run(std::vector<std::string> words) {
  CLI::App app("The smallest set of particles that matches a grain size distribution, exactly.", "mdm");
  app.formatter(std::make_shared<HelpFormatter>());
  app.footer(footer("", {"mdm solve sand.csv --proof sand.proof && mdm-check sand.csv sand.proof"}));
  const std::vector<Command> commands = add_commands(app);
  app.require_subcommand(0, 1);
  if (words.empty())
    return complain(fmt::format("mdm: a command is missing; there are {}; see mdm --help",
                                fmt::join(names(commands), ", ")));
  const std::string first = words.front();
  const auto is_first = [&first](const Command &c) { return c.app->get_name() == first; };
  if (first.rfind('-', 0) != 0 && std::none_of(commands.begin(), commands.end(), is_first))
    return complain(no_command(first, commands));
  const auto parsed = [&]() -> const CLI::App & {
    const std::vector<CLI::App *> sub = app.get_subcommands();
    return sub.empty() ? app : *sub.front();
  };
  try {
    std::reverse(words.begin(), words.end()); // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::CallForHelp &) {
    print(help_text(app, parsed()));
    return Exit::done;
  } catch (const CLI::CallForVersion &) {
    print(version_text() + "\n");
    return Exit::done;
  } catch (const CLI::ParseError &e) {
    const std::string of = &parsed() == &app ? "" : parsed().get_name() + " ";
    return complain(fmt::format("mdm: {}; see mdm {}--help", usage_error(e, app), of));
  }
  for (const Command &c : commands)
    if (c.app->parsed())
      return c.run();
  return complain(fmt::format("mdm: a command is missing; there are {}", fmt::join(names(commands), ", ")));
}

} // namespace

int main(int argc, char **argv) {
  occupy_standard_streams();
  spell_options_as_asked();
  use_number_pool();
  mdm::read_law_file = law_in_file;
  remove_unfinished_at_signals();
  let_writes_fail();
  try {
    return run(arguments(argc, argv));
  } catch (const ClosedPipe &) {
    return Exit::bad_input; // the reader has what it wanted
  } catch (const mdm::InputError &e) {
    return complain(e.what());
  } catch (const std::bad_alloc &) {
    return complain(out_of_memory_message);
  } catch (const std::exception &e) {
    return complain(fmt::format("mdm: internal error, please report it: {}", e.what()));
  }
}
