#include "proof_stream.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace mdm::checker {
namespace {

/// A number without a leading zero, of at most 18 digits; nothing for another text.
std::optional<std::uint64_t> natural(std::string_view text) {
  constexpr std::size_t most_digits = 18;
  if (text.empty() || text.size() > most_digits || !std::all_of(text.begin(), text.end(), is_digit) ||
      (text.size() > 1 && text[0] == '0'))
    return std::nullopt;
  return std::stoull(std::string(text));
}

/// Cuts off what stands before the first space, or all.
std::string_view next_word(std::string_view &text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

} // namespace

ProofStream::ProofStream(const std::string &path) : stream_(path), index_(path + ".index") {
  const std::optional<Input> header = index_.next();
  has_samples_ = header && header->text == "mdm-proofs sample 1";
  if (!header || !(has_samples_ || header->text == "mdm-proofs 1") || !index_.has_line_end())
    refuse_entry("the first line is not mdm-proofs 1 or mdm-proofs sample 1: give the index of mdm batch "
                 "--proofs or mdm crosscheck --proofs");
  read_entry();
}

std::string ProofStream::Entry::name() const {
  return "line " + std::to_string(number) + (answer > 1 ? ", answer " + std::to_string(answer) : "");
}

void ProofStream::refuse_entry(const std::string &what) const {
  throw Broken(printable(place()) + ": " + what);
}

void ProofStream::read_entry() {
  const std::optional<Input> line = index_.next();
  const std::optional<Entry> before = std::exchange(entry_, std::nullopt);
  if (!line)
    return;
  const Entry entry = parsed_entry(line->text);
  if (entry.number == 0 || entry.answer == 0 ||
      (before && std::pair(entry.number, entry.answer) <= std::pair(before->number, before->answer)))
    refuse_entry(entry.name() + " does not ascend: make the index again");
  if (has_samples_)
    check_length("sample", entry.sample_length);
  check_length("certificate", entry.length);
  entry_ = entry;
}

ProofStream::Entry ProofStream::parsed_entry(std::string_view text) const {
  std::array<std::uint64_t, 5> numbers{};
  const std::size_t count = has_samples_ ? 5 : 3;
  bool are_numbers = index_.has_line_end();
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<std::uint64_t> number = natural(i + 1 < count ? next_word(text) : text);
    are_numbers = are_numbers && number;
    numbers[i] = number.value_or(0);
  }
  if (!are_numbers)
    refuse_entry(
        has_samples_
            ? "no five numbers, of a line, an answer, an offset and two lengths: make the index again"
            : "no three numbers, of a line, an offset and a length: make the index again");
  const std::uint64_t offset = numbers[has_samples_ ? 2 : 1];
  if (offset != offset_)
    refuse_entry("offset " + std::to_string(offset) + ", where the certificate before ends at " +
                 std::to_string(offset_) + ": make the index again");
  if (!has_samples_)
    return {numbers[0], 1, 0, numbers[2]};
  return {numbers[0], numbers[1], numbers[3], numbers[4]};
}

void ProofStream::check_length(const char *what, std::uint64_t length) const {
  if (length == 0 || length > most_certificate_bytes)
    refuse_entry(std::string("a ") + what + " has 1 byte to 256 MiB: make the index again");
}

std::string_view ProofStream::stream_piece() {
  try {
    return stream_.some();
  } catch (const std::runtime_error &error) {
    throw Broken(error.what());
  }
}

Input ProofStream::take(const std::string &what, std::uint64_t length) {
  Input part{stream_.name() + " (" + what + ")", {}};
  while (part.text.size() < length) {
    const std::string_view some = stream_piece();
    if (some.empty())
      throw Broken(printable(part.name) + ": the stream ends before its " + std::to_string(length) +
                   " bytes: it was cut short");
    const auto taken =
        static_cast<std::size_t>(std::min<std::uint64_t>(some.size(), length - part.text.size()));
    part.text += some.substr(0, taken);
    stream_.take(taken);
  }
  offset_ += length;
  return part;
}

StreamedProof ProofStream::take() {
  std::optional<Input> sample;
  if (has_samples_)
    sample = take("sample of " + entry_->name(), entry_->sample_length);
  Input certificate = take("of " + entry_->name(), entry_->length);
  read_entry();
  return {std::move(sample), std::move(certificate)};
}

void ProofStream::check_end() {
  if (!stream_piece().empty())
    throw Broken(printable(stream_.name()) + ": goes on behind the " + std::to_string(offset_) +
                 " bytes of its index: one of them was cut short");
}

} // namespace mdm::checker
