// The files of shards become those of the whole suite, byte for byte as a run without shards writes them.
// Shard I of N has the lines I, I + N, I + 2 N, ...: answers, one a line, are joined by taking turns. Not
// every line has a certificate: of those that are next in their streams that of the smallest line is taken.
// Each file is read once, and compared with its totals as it goes.

#include "files/joined_parts.hpp"

#include "files/counted_part.hpp"

#include <memory>
#include <queue>

namespace mdm {

void join_lines(const std::vector<PartFile> &files, std::uint64_t lines, const Sink &to,
                const std::function<void()> &wrote) {
  std::vector<std::unique_ptr<CountedPart>> parts;
  for (const PartFile &file : files)
    parts.push_back(std::make_unique<CountedPart>(file.path, file.totals));
  for (std::uint64_t i = 0; i < lines; ++i, wrote())
    parts[i % parts.size()]->line(to);
  for (const std::unique_ptr<CountedPart> &part : parts)
    part->check_end();
}

void join_proofs(const std::vector<ProofFiles> &files, ProofStream &to) {
  std::vector<std::unique_ptr<CountedProofs>> parts;
  using Next = std::pair<std::uint64_t, std::size_t>; // line and part
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
  const auto add = [&](std::size_t part) {
    if (parts[part]->number() > 0)
      queue.emplace(parts[part]->number(), part);
  };
  for (const ProofFiles &file : files) {
    parts.push_back(std::make_unique<CountedProofs>(file.stream.path, file.stream.totals, file.index.path,
                                                    file.index.totals));
    add(parts.size() - 1);
  }
  while (!queue.empty()) {
    const auto [number, part] = queue.top();
    queue.pop();
    to.add(number, parts[part]->take([&to](std::string_view text) { to.stream().write(text); }));
    add(part);
  }
  for (const std::unique_ptr<CountedProofs> &part : parts)
    part->check_end();
}

} // namespace mdm
