#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "files/output.hpp"

#include <fmt/format.h>

#include <memory>
#include <vector>

namespace mdm::cli {
namespace {

/// An option as a shell completes it.
struct CompletedOption {
  std::string name; ///< with its dashes
  std::string help;
  bool takes_value = false;
  std::vector<std::string> values; ///< all that it takes; empty: any
};

struct CompletedCommand {
  std::string name, help;
  std::vector<CompletedOption> options;
};

/// The words of CLI11's description of a set of values, `{a,b}`; empty for other types.
std::vector<std::string> listed_values(const std::string &type) {
  std::vector<std::string> values;
  std::size_t begin = type.find('{');
  if (begin == std::string::npos || !type.ends_with('}'))
    return values;
  for (std::size_t end = begin; type[end] != '}'; begin = end) {
    end = type.find_first_of(",}", begin + 1);
    values.push_back(type.substr(begin + 1, end - begin - 1));
  }
  return values;
}

CompletedCommand completed(const CLI::App &command) {
  CompletedCommand c{command.get_name(), command.get_description(), {}};
  for (const CLI::Option *option : command.get_options()) {
    if (!option->nonpositional())
      continue;
    const auto add = [&c, option](const std::string &name) {
      c.options.push_back({name, option->get_description(), option->get_type_size() != 0,
                           listed_values(option->get_type_name())});
    };
    for (const std::string &name : option->get_lnames())
      add("--" + name);
    for (const std::string &name : option->get_snames())
      add("-" + name);
  }
  return c;
}

std::string joined(const std::vector<std::string> &words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// `text` between single quotes, for any shell, with `escaped` in place of a single quote.
std::string quoted(const std::string &text, const std::string &escaped) {
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? escaped : std::string(1, c);
  return quoted + "'";
}

std::string bash_script(const std::vector<CompletedCommand> &commands) {
  std::vector<std::string> names = {"help"};
  std::string options, values;
  for (const CompletedCommand &c : commands) {
    names.push_back(c.name);
    std::vector<std::string> of;
    for (const CompletedOption &o : c.options) {
      of.push_back(o.name);
      if (!o.values.empty())
        values += fmt::format("    '{} {}') words='{}' ;;\n", c.name, o.name, joined(o.values));
    }
    options += fmt::format("    {}) words='{}' ;;\n", c.name, joined(of));
  }
  return fmt::format(
      "# Completion of mdm for bash.\n"
      "_mdm() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} words=\n"
      "  if ((COMP_CWORD == 1)) || [[ $COMP_CWORD == 2 && ${{COMP_WORDS[1]}} == help ]]; then\n"
      "    words='{}'\n"
      "  elif [[ $word == -* ]]; then\n"
      "    case ${{COMP_WORDS[1]}} in\n{}    esac\n"
      "  else\n"
      "    case \"${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD - 1]}}\" in\n{}    esac\n"
      "  fi\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "}}\n"
      "complete -o default -F _mdm mdm\n",
      joined(names), options, values);
}

/// A description inside of zsh's brackets.
std::string zsh_help(const std::string &text) {
  std::string escaped;
  for (const char c : text)
    escaped += (c == '[' || c == ']' || c == ':' || c == '\\' ? "\\" : "") + std::string(1, c);
  return escaped;
}

std::string zsh_script(const std::vector<CompletedCommand> &commands) {
  std::string names, options;
  for (const CompletedCommand &c : commands) {
    names += "    " + quoted(c.name + ":" + zsh_help(c.help), "'\\''") + "\n";
    options += fmt::format("  {})\n    _arguments '*:file:_files'", c.name);
    for (const CompletedOption &o : c.options) {
      const std::string value = !o.takes_value     ? ""
                                : o.values.empty() ? ":value:_files"
                                                   : ":value:(" + joined(o.values) + ")";
      options += " \\\n      " + quoted("*" + o.name + "[" + zsh_help(o.help) + "]" + value, "'\\''");
    }
    options += " ;;\n";
  }
  return fmt::format("#compdef mdm\n"
                     "local -a commands\n"
                     "commands=(\n    'help:show the help of a command'\n{})\n"
                     "if (( CURRENT == 2 )) || [[ $CURRENT == 3 && $words[2] == help ]]; then\n"
                     "  _describe command commands\n"
                     "  return\n"
                     "fi\n"
                     "case $words[2] in\n{}esac\n",
                     names, options);
}

std::string fish_script(const std::vector<CompletedCommand> &commands) {
  std::string text = "# Completion of mdm for fish.\n"
                     "complete -c mdm -n __fish_use_subcommand -f -a help -d 'show the help of a command'\n";
  for (const CompletedCommand &c : commands) {
    text += fmt::format("complete -c mdm -n __fish_use_subcommand -f -a {} -d {}\n", c.name,
                        quoted(c.help, "\\'"));
    for (const CompletedOption &o : c.options) {
      const bool is_long = o.name.starts_with("--");
      text += fmt::format("complete -c mdm -n '__fish_seen_subcommand_from {}' {} {}{} -d {}\n", c.name,
                          is_long ? "-l" : "-s", o.name.substr(is_long ? 2 : 1),
                          !o.takes_value     ? ""
                          : o.values.empty() ? " -r"
                                             : " -x -a " + quoted(joined(o.values), "\\'"),
                          quoted(o.help, "\\'"));
    }
  }
  return text;
}

} // namespace

Run add_completion(CLI::App &app) {
  const auto shell = std::make_shared<std::string>();
  CLI::App &command =
      *app.add_subcommand("completion", "The completions of commands and options for a shell");
  command.add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command.footer(footer("", {"mdm completion bash > ~/.local/share/bash-completion/completions/mdm",
                             "mdm completion zsh > ~/.zfunc/_mdm",
                             "mdm completion fish > ~/.config/fish/completions/mdm.fish"}));
  return [&app, shell]() -> int {
    std::vector<CompletedCommand> commands;
    for (const CLI::App *c : app.get_subcommands({}))
      commands.push_back(completed(*c));
    write_output("-", *shell == "bash"  ? bash_script(commands)
                      : *shell == "zsh" ? zsh_script(commands)
                                        : fish_script(commands));
    return Exit::done;
  };
}

} // namespace mdm::cli
