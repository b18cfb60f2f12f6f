#include "particles/gsd.hpp"
#include "particles/gsd_layer.hpp"
#include "particles/line_reader.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace mdm {
namespace {

using gsd::Entry;
using gsd::Type;

/// The decimal that a float is.
std::string exact_decimal(float value) {
  constexpr int most_digits = 112;
  std::string text = fmt::format("{:.{}e}", static_cast<double>(value), most_digits - 1);
  const std::size_t exponent = text.find('e');
  const std::size_t last = text.find_last_not_of("0.", exponent - 1);
  return last == std::string::npos ? "0" : text.substr(0, last + 1) + text.substr(exponent);
}

/// Rows of bytes, each with a name up to its first zero.
struct GsdNames {
  std::string_view bytes;
  std::size_t columns = 1;

  /// Empty: there is none.
  std::string_view name(std::size_t row) const {
    const std::string_view rest = bytes.substr(std::min(bytes.size(), row * columns), columns);
    return rest.substr(0, rest.find('\0'));
  }
};

/// The chunks of a file, each within it.
class GsdChunks {
public:
  GsdChunks(std::string_view bytes, const std::string &file) : bytes_(bytes), file_(file) {
    const auto header = at<gsd::Header>(0);
    if (header.version < gsd::version_1 || header.version >= gsd::version_2 + gsd::version_1)
      refuse(fmt::format("version {} of the file layer is neither 1 nor 2: write it with such a GSD",
                         header.version >> 16U));
    check_schema(header);
    const std::vector<std::string> names = names_of(header);
    check_room(header.index_location, header.index_entries, sizeof(Entry));
    for (std::uint64_t i = 0; i < header.index_entries; ++i) {
      const auto entry = at<Entry>(header.index_location + i * sizeof(Entry));
      if (entry.location == 0)
        break;
      if (entry.name < names.size() && !chunks_.insert({{entry.frame, names[entry.name]}, entry}).second)
        refuse(fmt::format("frame {} has {} twice: is the file damaged?", entry.frame,
                           in_quotes(names[entry.name])));
    }
  }

  [[noreturn]] void refuse(const std::string &what) const {
    throw InputError(printable(file_) + ": " + what);
  }

  /// Those that have chunks of their own.
  std::set<std::uint64_t> frames() const {
    std::set<std::uint64_t> frames;
    for (const auto &[of, entry] : chunks_)
      frames.insert(of.first);
    return frames;
  }

  /// The chunk of a frame, or that of the first frame, which holds for all that have none.
  const Entry *find(std::uint64_t frame, const char *name) const {
    for (const std::uint64_t f : {frame, std::uint64_t{0}})
      if (const auto chunk = chunks_.find({f, name}); chunk != chunks_.end())
        return &chunk->second;
    return nullptr;
  }

  /// The numbers of a chunk; nothing where there is none. \throws InputError if they are of another type or
  /// number
  template <class T>
  std::optional<std::vector<T>> numbers(std::uint64_t frame, const char *name, Type type, std::uint64_t rows,
                                        std::uint32_t columns) const {
    const Entry *const entry = find(frame, name);
    if (entry == nullptr)
      return std::nullopt;
    if (entry->type != static_cast<std::uint8_t>(type) || entry->rows != rows || entry->columns != columns)
      refuse(fmt::format("{} has {} by {} numbers of type {}, {} by {} of type {} are expected: is the file "
                         "of schema hoomd?",
                         name, entry->rows, entry->columns, entry->type, rows, columns,
                         static_cast<unsigned>(type)));
    check_room(static_cast<std::uint64_t>(entry->location), rows, sizeof(T) * columns);
    std::vector<T> result(rows * columns);
    if (!result.empty()) // which has no place to copy to
      std::memcpy(result.data(), bytes_.data() + entry->location, result.size() * sizeof(T));
    return result;
  }

  /// The names in a chunk of bytes; none where it is no such chunk.
  GsdNames names_in(std::uint64_t frame, const char *name) const {
    const Entry *const entry = find(frame, name);
    const auto is_of = [entry](Type type) { return entry->type == static_cast<std::uint8_t>(type); };
    if (entry == nullptr || entry->columns == 0 || !(is_of(Type::int8) || is_of(Type::uint8)))
      return {};
    const auto location = static_cast<std::uint64_t>(entry->location);
    check_room(location, entry->rows, entry->columns);
    return {bytes_.substr(location, entry->rows * entry->columns), entry->columns};
  }

private:
  void check_schema(const gsd::Header &header) const {
    const std::string_view all(header.schema.data(), header.schema.size());
    const std::string_view schema = all.substr(0, all.find('\0'));
    if (schema != gsd::hoomd)
      refuse(
          fmt::format("its schema is {}, and not hoomd: its numbers mean something else", in_quotes(schema)));
    if (header.schema_version >> 16U != gsd::hoomd_schema >> 16U)
      refuse(fmt::format("version {} of schema hoomd is not 1: write it with such a GSD",
                         header.schema_version >> 16U));
  }

  void check_room(std::uint64_t location, std::uint64_t n, std::size_t size) const {
    if (location > bytes_.size() || n > (bytes_.size() - location) / size)
      refuse("the file ends before what its index names: is it cut off?");
  }

  template <class T>
  T at(std::uint64_t location) const {
    check_room(location, 1, sizeof(T));
    T value;
    std::memcpy(&value, bytes_.data() + location, sizeof(T));
    return value;
  }

  /// In version 1 each name has its place; in version 2 they follow each other, with a zero behind each.
  std::vector<std::string> names_of(const gsd::Header &header) const {
    check_room(header.names_location, header.names_entries, gsd::name_bytes);
    std::string_view rest = bytes_.substr(header.names_location, header.names_entries * gsd::name_bytes);
    std::vector<std::string> names;
    while (!rest.empty() && rest.front() != '\0') {
      const std::size_t length = std::min(rest.find('\0'), rest.size());
      names.emplace_back(rest.substr(0, length));
      const std::size_t step = header.version < gsd::version_2 ? gsd::name_bytes : length + 1;
      rest.remove_prefix(std::min(step, rest.size()));
    }
    return names;
  }

  std::string_view bytes_;
  const std::string &file_;
  std::map<std::pair<std::uint64_t, std::string>, Entry> chunks_;
};

std::uint64_t step_of(const GsdChunks &chunks, std::uint64_t frame) {
  const auto step = chunks.numbers<std::uint64_t>(frame, gsd::step_name, Type::uint64, 1, 1);
  return step ? step->front() : 0;
}

/// \throws InputError if there are none
std::set<std::uint64_t> frames_of(const GsdChunks &chunks) {
  std::set<std::uint64_t> frames = chunks.frames();
  if (frames.empty())
    chunks.refuse("there are no frames: a run has written none yet");
  return frames;
}

std::uint64_t frame_of(const GsdChunks &chunks, const std::optional<Integer> &step) {
  const std::set<std::uint64_t> frames = frames_of(chunks);
  if (!step)
    return *frames.rbegin();
  std::optional<std::uint64_t> found;
  for (const std::uint64_t frame : frames)
    if (step_of(chunks, frame) == *step)
      found = frame;
  if (!found)
    chunks.refuse(fmt::format("there is no timestep {}: the last is {}", to_string(*step),
                              step_of(chunks, *frames.rbegin())));
  return *found;
}

/// The box of HOOMD has its middle at the origin.
void set_box(const GsdChunks &chunks, std::uint64_t frame, ParticleSource &source) {
  const auto box = chunks.numbers<float>(frame, gsd::box_name, Type::float32, 6, 1);
  if (!box || !source.wants_places())
    return;
  std::array<std::array<std::string, 2>, 3> bounds;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float side = (*box)[axis];
    if (!std::isfinite(side) || (*box)[axis + 3] != 0)
      chunks.refuse("the box is not one with sides along the axes: give a frame of such a box");
    bounds[axis] = {exact_decimal(-side / 2), exact_decimal(side / 2)};
  }
  source.set_box(bounds, {true, true, true});
}

/// Hands on the particles of a frame.
void read_frame(const GsdChunks &chunks, std::uint64_t frame, ParticleSource &source) {
  const auto n = chunks.numbers<std::uint32_t>(frame, gsd::count_name, Type::uint32, 1, 1);
  const std::uint32_t particles = n ? n->front() : 0;
  const auto diameters = chunks.numbers<float>(frame, gsd::diameter_name, Type::float32, particles, 1);
  const auto places = chunks.numbers<float>(frame, gsd::position_name, Type::float32, particles, 3);
  const auto types = chunks.numbers<std::uint32_t>(frame, gsd::type_name, Type::uint32, particles, 1);
  const GsdNames type_names = chunks.names_in(frame, gsd::types_name);
  if (particles > 0 && !diameters)
    chunks.refuse("there are no particles/diameter: write them into the first frame");
  set_box(chunks, frame, source);
  for (std::size_t i = 0; i < particles; ++i) {
    source.set_line(i + 1); // messages name the particle by it
    const float d = (*diameters)[i];
    const std::array<float, 3> at =
        places ? std::array{(*places)[3 * i], (*places)[3 * i + 1], (*places)[3 * i + 2]}
               : std::array{0.F, 0.F, 0.F};
    if (!std::isfinite(d) || !std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2]))
      source.refuse("a number is not finite: is the file damaged?");
    if (types)
      source.take_class(type_names.name((*types)[i]));
    if (places && source.wants_places()) {
      const std::array<std::string, 3> text = {exact_decimal(at[0]), exact_decimal(at[1]),
                                               exact_decimal(at[2])};
      source.particle_at({text[0], text[1], text[2]}, exact_decimal(d));
    } else {
      source.particle(exact_decimal(d));
    }
  }
  source.check_some();
}

} // namespace

bool is_gsd(std::string_view beginning) {
  std::uint64_t first = 0;
  if (beginning.size() < sizeof(first))
    return false;
  std::memcpy(&first, beginning.data(), sizeof(first));
  return first == gsd::magic;
}

ReadParticles read_gsd(std::string_view bytes, const std::string &file, ParticleSink &sink,
                       const ParticleOptions &options) {
  if (!is_gsd(bytes))
    throw InputError(printable(file) + ": it does not begin as GSD does: say its format by " +
                     option("from"));
  const GsdChunks chunks(bytes, file);
  ParticleSource source(file, sink, options);
  source.set_defaults(SizeMeaning::diameter, SizeUnit::m);
  if (!options.every_timestep) {
    read_frame(chunks, frame_of(chunks, options.timestep), source);
  } else {
    for (const std::uint64_t frame : frames_of(chunks)) {
      source.begin_timestep(step_of(chunks, frame));
      read_frame(chunks, frame, source);
    }
  }
  ReadParticles result{{}, source.unit()};
  if (!options.unit)
    result.notes.push_back(source.size_note());
  return result;
}

} // namespace mdm
