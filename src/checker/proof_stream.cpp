#include "proof_stream.hpp"

#include "text.hpp"

#include <algorithm>

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
  if (!header || header->text != "mdm-proofs 1" || !index_.has_line_end())
    refuse_entry("the first line is not mdm-proofs 1: give the index of mdm batch --proofs");
  read_entry();
}

void ProofStream::refuse_entry(const std::string &what) const {
  throw Broken(printable(place()) + ": " + what);
}

void ProofStream::read_entry() {
  const std::optional<Input> line = index_.next();
  const std::uint64_t before = number_.value_or(0);
  number_.reset();
  if (!line)
    return;
  std::string_view text = line->text;
  const std::optional<std::uint64_t> number = natural(next_word(text)), offset = natural(next_word(text)),
                                     length = natural(text);
  if (!number || !offset || !length || !index_.has_line_end())
    refuse_entry("no three numbers, of a line, an offset and a length: make the index again");
  if (*number <= before)
    refuse_entry("line " + std::to_string(*number) + " does not ascend: make the index again");
  if (*offset != offset_)
    refuse_entry("offset " + std::to_string(*offset) + ", where the certificate before ends at " +
                 std::to_string(offset_) + ": make the index again");
  if (*length == 0 || *length > most_certificate_bytes)
    refuse_entry("a certificate has 1 byte to 256 MiB: make the index again");
  number_ = number;
  length_ = *length;
}

std::string_view ProofStream::stream_piece() {
  try {
    return stream_.some();
  } catch (const std::runtime_error &error) {
    throw Broken(error.what());
  }
}

Input ProofStream::take() {
  Input certificate{stream_.name() + " (of line " + std::to_string(*number_) + ")", {}};
  while (certificate.text.size() < length_) {
    const std::string_view some = stream_piece();
    if (some.empty())
      throw Broken(printable(certificate.name) + ": the stream ends before its " + std::to_string(length_) +
                   " bytes: it was cut short");
    const auto taken =
        static_cast<std::size_t>(std::min<std::uint64_t>(some.size(), length_ - certificate.text.size()));
    certificate.text += some.substr(0, taken);
    stream_.take(taken);
  }
  offset_ += length_;
  read_entry();
  return certificate;
}

void ProofStream::check_end() {
  if (!stream_piece().empty())
    throw Broken(printable(stream_.name()) + ": goes on behind the " + std::to_string(offset_) +
                 " bytes of its index: one of them was cut short");
}

} // namespace mdm::checker
