#include "files/solver.hpp"

#include "files/child_process.hpp"

#include <mdm/gradation/write_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// The exit code of /bin/sh for a command that is not there.
constexpr int not_found = 127;
constexpr std::size_t most_answer_bytes = std::size_t{64} << 20;

/// The last words of the program on its standard error.
std::string said(const ChildEnd &end) {
  return end.last_error.empty() ? "" : ": " + in_quotes(end.last_error);
}

} // namespace

ProgramAnswer ask_program(const std::string &command, const std::string &question,
                          std::chrono::milliseconds time_limit) {
  const auto failed = [](AnswerVerdict failure, std::string reason) {
    return ProgramAnswer{"", failure, std::move(reason)};
  };
  const ChildEnd end = run_child(command, question, time_limit, most_answer_bytes);
  switch (end.how) {
  case ChildEnd::How::timed_out:
    return failed(AnswerVerdict::timeout,
                  fmt::format("no end within {} s", decimal_string(time_limit.count(), 3)));
  case ChildEnd::How::too_much_output:
    return failed(AnswerVerdict::garbage, fmt::format("more than {} MiB of output", most_answer_bytes >> 20));
  case ChildEnd::How::signalled:
    return failed(AnswerVerdict::crashed, fmt::format("signal {}{}", end.code, said(end)));
  case ChildEnd::How::exited:
    break;
  }
  if (end.code != 0)
    return failed(AnswerVerdict::crashed,
                  fmt::format("exit code {}{}{}", end.code,
                              end.code == not_found ? ": /bin/sh did not find it" : "", said(end)));
  if (end.output.find_first_not_of(" \t\r\n") == std::string::npos)
    return failed(AnswerVerdict::no_answer, "no output" + said(end));
  return {end.output, std::nullopt, ""};
}

Solver::Solver(std::string command, std::chrono::milliseconds time_limit,
               const std::optional<std::string> &journal)
    : command_(std::move(command)), time_limit_(time_limit) {
  if (journal)
    journal_ = std::make_unique<Journal>(*journal, command_);
}

OtherAnswer Solver::answer(const Gradation &g, std::uint64_t line) {
  if (const OtherAnswer *const kept = journal_ ? journal_->find(line, g) : nullptr)
    return *kept;
  OtherAnswer answer = ask(g);
  answer.id = g.id();
  if (journal_)
    journal_->add(line, g, answer);
  return answer;
}

OtherAnswer Solver::ask(const Gradation &g) const {
  const ProgramAnswer said = ask_program(command_, gradation_json(g), time_limit_);
  if (said.failure)
    return failed_answer("", *said.failure, said.reason);
  OtherAnswer answer = json_answer(said.text);
  if (!answer.id.empty() && answer.id != g.id())
    return failed_answer("", AnswerVerdict::garbage, "the answer is for " + in_quotes(answer.id));
  return answer;
}

} // namespace mdm
