#include "files/batch_sources.hpp"

#include "files/file_ending.hpp"
#include "files/paths.hpp"
#include "gradation/material_gradation.hpp"
#include "gradation/workbook.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace mdm {
namespace {

constexpr std::string_view white_space = " \t\r\n";

/// `text` from its first character on that is no white space.
std::string_view without_blank_lines(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(white_space), text.size()));
}

/// True where a file that begins so is JSON Lines: its first line is an object, or its second begins one; a
/// gradation in JSON has one object, on lines of its own. Nothing while the beginning does not say it.
std::optional<bool> begins_suite(std::string_view beginning, bool is_all) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (is_workbook(beginning)) // in whose bytes a line may begin anywhere
    return false;
  if (beginning.starts_with(byte_order_mark))
    beginning.remove_prefix(byte_order_mark.size());
  const std::string_view text = without_blank_lines(beginning);
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view second = without_blank_lines(text.substr(end));
  const std::string_view first = text.substr(0, text.find_last_not_of(white_space, end) + 1);
  if (end < text.size() && first.starts_with('{') && first.ends_with('}'))
    return true;
  if (!second.empty())
    return second.starts_with('{');
  if (is_all)
    return first.starts_with('{');
  return std::nullopt;
}

/// True where an empty file is a suite without lines: its name does not say that it is a table.
bool may_have_no_line(const std::string &name) {
  const std::string ending = ending_of(name);
  return ending.empty() || ending == "jsonl" || ending == "ndjson";
}

bool is_suite(FileLines &file, const std::string &name) {
  constexpr std::size_t longest_look = std::size_t{1} << 20;
  for (;;) {
    const std::string_view beginning = file.look_further();
    if (file.is_at_end() && without_blank_lines(beginning).empty())
      return may_have_no_line(name);
    if (const std::optional<bool> known = begins_suite(beginning, file.is_at_end()))
      return *known;
    if (beginning.size() > longest_look)
      return without_blank_lines(beginning).starts_with('{');
  }
}

/// \param line without it the line was too long
BatchItem item_of_line(const FileLines::Line &line, std::uint64_t number, const std::string &where,
                       const std::string &fallback_id) {
  BatchItem item{number, where, [fallback_id] { return fallback_id; }, {}, {}};
  if (!line) {
    item.read = [where]() -> Gradation {
      throw InputError(printable(where) + ": " + FileLines::too_long("the line") +
                       ": write one gradation a line");
    };
  } else {
    const auto text = std::make_shared<const std::string>(*line);
    item.id = [text, fallback_id] { return json_gradation_id(*text).value_or(fallback_id); };
    item.read = [text, where, fallback_id] { return read_json_gradation(*text, where, fallback_id); };
  }
  return item;
}

} // namespace

BatchSources::BatchSources(std::vector<std::string> files, Reading reading, std::string asked,
                           bool only_suites)
    : files_(std::move(files)), reading_(std::move(reading)), asked_(std::move(asked)),
      only_suites_(only_suites), is_stream_(files_.empty()) {
  if (is_stream_)
    files_.emplace_back("-");
}

BatchSources::BatchSources(std::vector<std::string> files, Reading reading, std::string asked, Shard shard,
                           bool alone)
    : BatchSources(std::move(files), std::move(reading), std::move(asked), true) {
  shard_ = shard;
  is_alone_ = alone;
  hash_.emplace();
}

std::optional<MadeSuite> BatchSources::made() {
  if (is_alone_ && opened_ == 0) {
    open(files_[opened_++]);
    std::string_view beginning = suite_->look_further();
    while (begins_made_shard(beginning) && beginning.find('\n') == std::string_view::npos &&
           !suite_->is_at_end())
      beginning = suite_->look_further();
    if (begins_made_shard(beginning))
      take_made(suite_->next(1).at(0).value_or(""));
  }
  return made_shard_ ? std::optional(made_shard_->suite) : std::nullopt;
}

void BatchSources::tell_lines(Totals &totals) const {
  totals.sum = sum_;
  if (made_shard_)
    totals.made = made_shard_->suite;
  const std::string &file = files_[0];
  if (!is_alone_ && file_totals_)
    totals.suite = SuiteTotals{*file_totals_, suite_sum_};
  else if (is_alone_ && file_totals_ && file_bytes(file))
    totals.alone = file_totals_;
}

std::vector<BatchItem> BatchSources::next(std::size_t most) {
  constexpr std::size_t most_bytes = max_gradation_bytes;
  std::vector<BatchItem> items;
  while (items.empty()) {
    if (!waiting_.empty()) {
      const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(std::min(most, waiting_.size()));
      std::move(waiting_.begin(), end, std::back_inserter(items));
      waiting_.erase(waiting_.begin(), end);
    } else if (suite_) {
      add_lines(items, most);
    } else if (opened_ == files_.size()) {
      break;
    } else {
      waiting_bytes_ = 0;
      do
        open(files_[opened_++]);
      while (!suite_ && opened_ < files_.size() && waiting_.size() < most && waiting_bytes_ < most_bytes);
    }
  }
  return items;
}

void BatchSources::open(const std::string &file) {
  auto content = std::make_unique<FileLines>(file);
  if (shard_)
    content->bytes().keep_digest();
  if (is_stream_ || is_suite(*content, file)) {
    if (!asked_.empty())
      throw file_error(shown_name(file), asked_ + " is of gradation files, and this is JSON Lines, which "
                                                  "say what they hold: leave it out");
    suite_ = std::move(content);
    line_ = 0;
  } else if (only_suites_) {
    throw file_error(shown_name(file), "no suite in JSON Lines: name one, or " +
                                           (shard_ ? "leave out " + option("shard")
                                                   : "give " + option("proofs") + " a folder"));
  } else {
    add_gradations(shown_name(file), *content);
  }
}

void BatchSources::add_materials(const std::string &file, std::shared_ptr<const std::string> text) {
  refuse_beside_materials(asked_, file);
  waiting_.push_back({++count_, file, [file] { return stem(file); },
                      [text, file] { return read_material_gradation(*text, file); },
                      [text](const Gradation &) { return *text; }});
}

void BatchSources::add_gradations(const std::string &file, FileLines &content) {
  try {
    const auto text = std::make_shared<const std::string>(content.rest(max_gradation_bytes));
    waiting_bytes_ += text->size();
    if (is_material_gradation(*text))
      return add_materials(file, text);
    const bool is_one = !is_ags4(*text);
    for (UnreadGradation &g : gradations_in(*text, file, reading_)) {
      BatchItem item{++count_, file, [id = g.id] { return id; }, std::move(g.read), {}};
      item.checked_as = [text, file, is_one, reading = reading_](const Gradation &read) {
        return is_one && understand_gradation(*text, file, reading).is_canonical ? *text
                                                                                 : gradation_csv(read);
      };
      waiting_.push_back(std::move(item));
    }
  } catch (const InputError &e) {
    const auto refuse = [error = e]() -> Gradation { throw error; };
    waiting_.push_back({++count_, file, [file] { return stem(file); }, refuse, {}});
  }
}

void BatchSources::take_made(const std::string &line) {
  const std::string name = line_name(files_[opened_ - 1], 1);
  made_shard_ = in_file(name, [&line] { return read_made_shard(line); });
  const std::string shard = fmt::format("{}/{}", made_shard_->shard, made_shard_->shards);
  if (!is_alone_)
    throw file_error(name, "the lines are those of shard " + shard + " alone: give " + option("shard") + " " +
                               shard + " " + option("alone"));
  if (made_shard_->shard != shard_->number || made_shard_->shards != shard_->count)
    throw file_error(name, fmt::format("the lines are those of shard {}, and {} is {}/{}: give its own",
                                       shard, option("shard"), shard_->number, shard_->count));
}

void BatchSources::count_line(const FileLines::Line &line) {
  if (FileLines::is_blank(line) || !shard_)
    return;
  const std::uint64_t number = is_alone_ ? shard_->number + filled_lines_ * shard_->count : filled_lines_ + 1;
  const LineSum::Hash hash = hash_->of(number, line);
  suite_sum_.add(hash);
  if (is_ours(line))
    sum_.add(hash);
}

void BatchSources::end_suite() {
  if (made_shard_ && filled_lines_ != made_shard_->lines)
    throw file_error(shown_name(files_[opened_ - 1]),
                     fmt::format("there are {} lines, and its first line says {}: give all of the shard",
                                 filled_lines_, made_shard_->lines));
  if (shard_)
    file_totals_ = FileTotals{suite_->bytes().digest().bytes(), suite_->bytes().digest().sha256()};
  suite_.reset();
}

/// True of the lines that are items.
bool BatchSources::is_ours(const FileLines::Line &line) {
  return !FileLines::is_blank(line) && (!shard_ || is_alone_ || shard_->has(filled_lines_ + 1));
}

void BatchSources::add_lines(std::vector<BatchItem> &items, std::size_t most) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20;
  std::size_t bytes = 0;
  do {
    const std::vector<FileLines::Line> lines = suite_->next(most - items.size());
    if (lines.empty())
      return end_suite();
    for (const FileLines::Line &line : lines) {
      if (line_ == 0 && !made_shard_ && line && begins_made_shard(*line)) {
        take_made(*line);
        continue;
      }
      line_ = is_alone_ ? shard_->number + filled_lines_ * shard_->count : line_ + 1;
      count_ = is_alone_ ? line_ : count_ + 1;
      if (is_ours(line)) {
        items.push_back(
            item_of_line(line, count_, line_name(files_[opened_ - 1], line_), std::to_string(line_)));
        bytes += line ? line->size() : 0;
        // Of several files the numbers of gradations are not those of lines.
        if (line && files_.size() > 1)
          items.back().checked_as = [text = *line](const Gradation &) { return text; };
      }
      count_line(line);
      if (!FileLines::is_blank(line))
        ++filled_lines_;
    }
  } while (shard_ && !is_alone_ && items.size() < most && bytes < most_bytes); // its lines are far apart
}

} // namespace mdm
