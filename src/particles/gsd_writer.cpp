#include "particles/gsd_layer.hpp"
#include "particles/particle_writer.hpp"

#include <cstdlib>
#include <numbers>
#include <vector>

namespace mdm {
namespace {

using gsd::Entry;
using gsd::Type;

std::size_t bytes_of(Type type) {
  switch (type) {
  case Type::uint8:
    return 1;
  case Type::uint64:
    return 8;
  default:
    return 4;
  }
}

/// A file of one frame: what comes when is laid out first, then written in that order.
class GsdWriter {
public:
  GsdWriter(const Placement &start, const Sink &out) : start_(start), out_(out), half_{} {
    for (std::size_t axis = 0; axis < 3; ++axis)
      half_[axis] = length(start.box()[axis]) / 2;
  }

  void write() {
    add(gsd::step_name, Type::uint64, 1, 1);
    add(gsd::box_name, Type::float32, 6, 1);
    add(gsd::count_name, Type::uint32, 1, 1);
    add(gsd::types_name, Type::uint8, start_.set().classes.size(), type_bytes);
    const auto n = static_cast<std::uint64_t>(start_.set().particles());
    add(gsd::type_name, Type::uint32, n, 1);
    add(gsd::mass_name, Type::float32, n, 1);
    add(gsd::diameter_name, Type::float32, n, 1);
    add(gsd::position_name, Type::float32, n, 3);
    write_head();
    put(std::uint64_t{0});
    for (std::size_t axis = 0; axis < 6; ++axis)
      put(axis < 3 ? static_cast<float>(2 * half_[axis]) : 0.F);
    put(static_cast<std::uint32_t>(n));
    for (const ParticleClass &c : start_.set().classes)
      put(type_of(c));
    start_.each([this](const Placement::Sphere &s) { put(static_cast<std::uint32_t>(s.class_index)); });
    start_.each([this](const Placement::Sphere &s) { put(mass_of(s)); });
    start_.each([this](const Placement::Sphere &s) { put(static_cast<float>(s.size->diameter.value)); });
    start_.each([this](const Placement::Sphere &s) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        put(static_cast<float>(length(s.at[axis]) - half_[axis]));
    });
    finish();
  }

private:
  static constexpr std::size_t type_bytes = 24; ///< longer than any number

  void add(const char *name, Type type, std::uint64_t rows, std::uint32_t columns) {
    const auto number = static_cast<std::uint16_t>(entries_.size());
    entries_.push_back(
        {0, rows, static_cast<std::int64_t>(end_), columns, number, static_cast<std::uint8_t>(type), 0});
    names_ += name;
    names_ += '\0';
    end_ += rows * columns * bytes_of(type);
  }

  /// Chunks lie behind header, names and index.
  void write_head() {
    gsd::Header header;
    header.names_location = sizeof(gsd::Header);
    header.names_entries = names_.size() / gsd::name_bytes + 1;
    header.index_location = header.names_location + header.names_entries * gsd::name_bytes;
    header.index_entries = entries_.size() + 1;
    std::string("mdm").copy(header.application.data(), header.application.size() - 1);
    std::string("hoomd").copy(header.schema.data(), header.schema.size() - 1);
    names_.resize(header.names_entries * gsd::name_bytes);
    put(header);
    buffer_ += names_;
    const auto head = static_cast<std::int64_t>(header.index_location + header.index_entries * sizeof(Entry));
    for (Entry entry : entries_) {
      entry.location += head;
      put(entry);
    }
    put(Entry{});
  }

  double length(std::int64_t units) const { return std::strtod(start_.text(units).c_str(), nullptr); }

  static std::array<char, type_bytes> type_of(const ParticleClass &c) {
    std::array<char, type_bytes> name{};
    std::to_string(c.number).copy(name.data(), type_bytes - 1);
    return name;
  }

  float mass_of(const Placement::Sphere &s) const {
    const double density = start_.set().classes[s.class_index].density.convert_to<double>();
    const double d = s.size->diameter.value;
    return static_cast<float>(std::numbers::pi / 6 * density * d * d * d);
  }

  template <class T>
  void put(const T &value) {
    constexpr std::size_t piece = std::size_t{64} << 10;
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    buffer_.append(bytes.data(), bytes.size());
    if (buffer_.size() >= piece)
      finish();
  }

  void finish() {
    out_(buffer_);
    buffer_.clear();
  }

  const Placement &start_;
  const Sink &out_;
  std::array<double, 3> half_; ///< of the box's sides
  std::vector<Entry> entries_;
  std::string names_, buffer_;
  std::uint64_t end_ = 0; ///< of the chunks so far
};

} // namespace

void write_gsd(const Placement &start, const Sink &out) {
  GsdWriter(start, out).write();
}

} // namespace mdm
