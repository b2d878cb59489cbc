#include "files/part_file.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text_file.hpp"

#include <bit>
#include <string_view>
#include <utility>

namespace pastoso::files {
namespace {

static_assert(std::endian::native == std::endian::little, "files are written in little endian");

// Where things lie in the head. Behind the facts follow the parts' sizes, then the checksum of all
// before and after it.
constexpr std::size_t kVersionAt = 8, kFlagsAt = 12, kSceneAt = 16, kFactsAt = 24;
constexpr std::size_t kNumber = sizeof(std::uint64_t);

/// Of all of a file but the checksum at the end of its head.
std::uint64_t checksum(std::string_view file, std::size_t head_bytes) {
    core::Hash64 hash;
    hash.add(std::span(file.data(), head_bytes - kNumber));
    const std::string_view content = file.substr(head_bytes);
    hash.add(std::span(content.data(), content.size()));
    return hash.value();
}

core::Message versions_read(const PartFileKind& kind) {
    if (kind.oldest == kind.version) return core::message("version %1", kind.version);
    return core::message("versions %1 to %2", kind.oldest, kind.version);
}

core::Message ends_within(std::size_t head_bytes) {
    return core::message("is damaged (it ends within its first %1 bytes).", head_bytes);
}

template <class Value>
void append(std::string& file, const Value& value) {
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::size_t PartFileKind::head_bytes(std::uint32_t of_version) const {
    return kFactsAt + fact_bytes_of(of_version) + kNumber * parts + kNumber;
}

/// All first bytes of the values, then all second ones: those of neighbours resemble each other.
void PartFileWriter::add_bytes(std::span<const std::byte> values, std::size_t value_bytes) {
    const std::size_t count = values.size() / value_bytes;
    packing::Bytes planes(values.size());
    for (std::size_t n = 0; n < count; ++n)
        for (std::size_t b = 0; b < value_bytes; ++b)
            planes[b * count + n] = values[n * value_bytes + b];
    parts_.push_back(packer_.packed(planes));
}

void PartFileWriter::write_bytes(const std::filesystem::path& path, std::uint64_t scene_hash,
                                 std::uint32_t flags, std::span<const std::byte> facts) const {
    PASTOSO_CHECK_OP(facts.size(), ==, kind_.fact_bytes);
    PASTOSO_CHECK_OP(parts_.size(), ==, kind_.parts);
    std::string file(kind_.mark.data(), kind_.mark.size());
    append(file, kind_.version);
    append(file, flags);
    append(file, scene_hash);
    file.append(reinterpret_cast<const char*>(facts.data()), facts.size());
    for (const packing::Bytes& part : parts_)
        append(file, std::uint64_t{part.size()});
    append(file, std::uint64_t{0});
    for (const packing::Bytes& part : parts_)
        file.append(reinterpret_cast<const char*>(part.data()), part.size());
    const std::size_t head = kind_.head_bytes(kind_.version);
    const std::uint64_t sum = checksum(file, head);
    std::memcpy(file.data() + head - kNumber, &sum, sizeof sum);
    core::write_text_file(path, file);
}

PartFileReader::PartFileReader(std::filesystem::path path, const PartFileKind& kind,
                               std::uint64_t scene_hash)
    : path_(std::move(path)),
      kind_(kind),
      file_(core::read_text_file(path_, kind.head_bytes(kind.version) + kind.most_bytes)) {
    const core::Message sentence = fault(scene_hash);
    if (!sentence.empty()) refuse(sentence);
    next_at_ = head_bytes();
}

void PartFileReader::refuse(const core::Message& sentence) const {
    throw core::InputError("%1: %2", path_.string(), sentence);
}

std::uint64_t PartFileReader::number_at(std::size_t byte) const {
    std::uint64_t number = 0;
    std::memcpy(&number, file_.data() + byte, sizeof number);
    return number;
}

std::uint64_t PartFileReader::part_bytes(std::size_t part) const {
    return number_at(kFactsAt + kind_.fact_bytes_of(version_) + kNumber * part);
}

/// What the file is instead of one of ours; empty when it is one, whose version and flags are then
/// known.
core::Message PartFileReader::fault(std::uint64_t scene_hash) {
    if (!std::string_view(file_).starts_with(std::string_view(kind_.mark.data(), kind_.mark.size())))
        return core::message("is no %1.", core::message(kind_.what));
    if (file_.size() < kSceneAt) return ends_within(kSceneAt);
    std::memcpy(&version_, file_.data() + kVersionAt, sizeof version_);
    std::memcpy(&flags_, file_.data() + kFlagsAt, sizeof flags_);
    if (version_ < kind_.oldest || version_ > kind_.version)
        return core::message("is of version %1, this program reads %2.", version_, versions_read(kind_));
    if (file_.size() < head_bytes()) return ends_within(head_bytes());
    std::uint64_t left = file_.size() - head_bytes();
    for (std::size_t part = 0; part < kind_.parts; ++part) {
        if (part_bytes(part) > left) return core::message("is damaged (it is shorter than it says).");
        left -= part_bytes(part);
    }
    if (left != 0) return core::message("is damaged (it is longer than it says).");
    if (number_at(head_bytes() - kNumber) != checksum(file_, head_bytes()))
        return core::message("is damaged (its checksum is another).");
    if (number_at(kSceneAt) != scene_hash) return core::message("belongs to another scene.");
    return {};
}

void PartFileReader::copy_facts(std::span<std::byte> facts) const {
    PASTOSO_CHECK_OP(facts.size(), ==, kind_.fact_bytes);
    std::memcpy(facts.data(), file_.data() + kFactsAt, kind_.fact_bytes_of(version_));
}

void PartFileReader::skip() {
    PASTOSO_CHECK_OP(part_, <, kind_.parts);
    next_at_ += part_bytes(part_++);
}

std::size_t PartFileReader::unpack_next(std::size_t bytes) {
    const std::size_t at = next_at_;
    skip();
    const auto packed = std::as_bytes(std::span(file_)).subspan(at, next_at_ - at);
    try {
        unpacked_ = unpacker_.unpacked(packed, bytes);
    } catch (const core::InputError& error) {
        refuse(error.message());
    }
    return unpacked_.size();
}

void PartFileReader::copy_values(std::span<std::byte> values, std::size_t value_bytes) const {
    const std::size_t count = values.size() / value_bytes;
    for (std::size_t n = 0; n < count; ++n)
        for (std::size_t b = 0; b < value_bytes; ++b)
            values[n * value_bytes + b] = unpacked_[b * count + n];
}

}  // namespace pastoso::files
