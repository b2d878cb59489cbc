#include "io/tea_file.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text_file.hpp"
#include "packing/packed_bytes.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace pastoso::io {
namespace {

using grid::BoxField;
using grid::BoxShape;
using liquid::Parcel;
using liquid::TeaFrame;
using packing::Bytes;

static_assert(std::endian::native == std::endian::little, "frames are written in little endian");

constexpr std::array<char, 8> kMark = {'P', 'a', 's', 't', 'o', 'T', 'e', 'a'};
constexpr std::size_t kParts = 3;  ///< parcels, dissolved, coldness

/// The beginning of a file.
struct Head {
    std::array<char, 8> mark = kMark;
    std::uint32_t version = kTeaFileVersion;
    std::uint32_t has_coldness = 0;
    std::uint64_t scene_hash = 0;
    double time_s = 0.0;
    std::int64_t step = 0;
    std::int32_t nx = 0, ny = 0, nz = 0;
    float cell_m = 0.0F;
    std::uint64_t parcel_count = 0;
    std::array<std::uint64_t, kParts> packed_bytes{};
    std::uint64_t checksum = 0;  ///< of all before it and all after it
};
static_assert(sizeof(Head) == 96 && std::is_trivially_copyable_v<Head>);
constexpr std::size_t kSummedHeadBytes = sizeof(Head) - sizeof(std::uint64_t);

/// A parcel as it is written.
struct ParcelRecord {
    float x_m, y_m, z_m, volume_m3, coldness;
    std::int32_t ball;
};
static_assert(sizeof(ParcelRecord) == 24);

std::uint64_t checksum(std::string_view file) {
    core::Hash64 hash;
    hash.add(std::span(file.data(), kSummedHeadBytes));
    const std::string_view content = file.substr(sizeof(Head));
    hash.add(std::span(content.data(), content.size()));
    return hash.value();
}

/// All first bytes of the values, then all second ones: those of neighbours resemble each other.
template <class Value>
Bytes planes_of(const std::vector<Value>& values) {
    Bytes planes(values.size() * sizeof(Value));
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    for (std::size_t n = 0; n < values.size(); ++n)
        for (std::size_t b = 0; b < sizeof(Value); ++b)
            planes[b * values.size() + n] = bytes[n * sizeof(Value) + b];
    return planes;
}

template <class Value>
std::vector<Value> values_of(std::span<const std::byte> planes) {
    std::vector<Value> values(planes.size() / sizeof(Value));
    auto* bytes = reinterpret_cast<std::byte*>(values.data());
    for (std::size_t n = 0; n < values.size(); ++n)
        for (std::size_t b = 0; b < sizeof(Value); ++b)
            bytes[n * sizeof(Value) + b] = planes[b * values.size() + n];
    return values;
}

std::vector<ParcelRecord> records_of(const std::vector<Parcel>& parcels) {
    std::vector<ParcelRecord> records;
    records.reserve(parcels.size());
    for (const Parcel& parcel : parcels) {
        const glm::vec3& at = parcel.position_m;
        records.push_back({at.x, at.y, at.z, parcel.volume_m3, parcel.coldness, parcel.ball});
    }
    return records;
}

std::vector<float> interior_of(const BoxField& field) {
    const BoxShape& shape = field.shape();
    std::vector<float> values;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            values.insert(values.end(), field.row(j, k), field.row(j, k) + shape.nx);
    return values;
}

std::int64_t cell_count(const Head& head) {
    return std::int64_t{head.nx} * head.ny * head.nz;
}

bool is_allowed(const Head& head) {
    for (const std::int32_t side : {head.nx, head.ny, head.nz})
        if (side < 0 || side > kMostTeaCellsAlong) return false;
    const bool has_cells = head.nx > 0 && head.ny > 0 && head.nz > 0;
    const bool is_empty = head.nx == 0 && head.ny == 0 && head.nz == 0 && head.has_coldness == 0;
    if (!is_empty && !(has_cells && head.cell_m > 0.0F && std::isfinite(head.cell_m))) return false;
    return cell_count(head) <= kMostTeaCells && head.has_coldness <= 1 &&
           head.parcel_count <= std::uint64_t{kMostTeaParcels} && std::isfinite(head.time_s) &&
           head.step >= 0 && head.step <= std::int64_t{1} << 30;
}

Head head_of(const TeaFrame& frame, std::uint64_t scene_hash) {
    const BoxShape& shape = frame.dissolved.shape();
    Head head;
    head.has_coldness = frame.coldness.shape().nx > 0 ? 1 : 0;
    PASTOSO_CHECK(head.has_coldness == 0 || frame.coldness.shape() == shape);
    head.scene_hash = scene_hash;
    head.time_s = frame.time_s;
    head.step = frame.step;
    head.nx = shape.nx;
    head.ny = shape.ny;
    head.nz = shape.nz;
    head.cell_m = shape.cell_m;
    head.parcel_count = frame.parcels.size();
    PASTOSO_CHECK(is_allowed(head));
    return head;
}

/// The head of a file that is one of ours, of this version and whole; a sentence about what it is
/// instead.
std::string read_head(std::string_view file, std::uint64_t scene_hash, Head& head) {
    if (file.substr(0, kMark.size()) != std::string_view(kMark.data(), kMark.size()))
        return "is no frame of tea.";
    if (file.size() < sizeof(Head))
        return "is damaged (it ends within its first " + std::to_string(sizeof(Head)) + " bytes).";
    std::memcpy(&head, file.data(), sizeof head);
    if (head.version != kTeaFileVersion) {
        return "is of version " + std::to_string(head.version) + ", this program reads version " +
               std::to_string(kTeaFileVersion) + ".";
    }
    std::uint64_t left = file.size() - sizeof(Head);
    for (const std::uint64_t bytes : head.packed_bytes) {
        if (bytes > left) return "is damaged (it is shorter than it says).";
        left -= bytes;
    }
    if (left != 0) return "is damaged (it is longer than it says).";
    if (head.checksum != checksum(file)) return "is damaged (its checksum is another).";
    if (!is_allowed(head)) return "holds sizes or times that no frame has.";
    if (head.scene_hash != scene_hash) return "belongs to another scene.";
    return {};
}

std::size_t most_file_bytes() {
    const auto cells = static_cast<std::size_t>(kMostTeaCells);
    return sizeof(Head) + 2 * packing::most_packed_bytes(sizeof(float) * cells) +
           packing::most_packed_bytes(sizeof(ParcelRecord) * static_cast<std::size_t>(kMostTeaParcels));
}

/// Reads the parts of a file one after the other.
class Parts {
  public:
    Parts(std::string_view file, const Head& head) : rest_(file.substr(sizeof(Head))), head_(head) {}

    template <class Value>
    std::vector<Value> next(std::size_t count) {
        const std::string_view packed = rest_.substr(0, head_.packed_bytes[part_]);
        rest_.remove_prefix(packed.size());
        ++part_;
        return values_of<Value>(
            unpacker_.unpacked(std::as_bytes(std::span(packed)), count * sizeof(Value)));
    }

  private:
    std::string_view rest_;
    const Head& head_;
    std::size_t part_ = 0;
    packing::Unpacker unpacker_;
};

BoxField read_field(const Head& head, Parts& parts) {
    const std::vector<float> values = parts.next<float>(static_cast<std::size_t>(cell_count(head)));
    for (const float value : values)
        if (!std::isfinite(value)) throw core::InputError("holds a value of a cell that is not finite.");
    BoxField field({head.nx, head.ny, head.nz, head.cell_m});
    const float* row = values.data();
    for (int k = 0; k < head.nz; ++k)
        for (int j = 0; j < head.ny; ++j, row += head.nx)
            std::copy(row, row + head.nx, field.row(j, k));
    return field;
}

std::vector<Parcel> read_parcels(const Head& head, Parts& parts) {
    std::vector<Parcel> parcels;
    parcels.reserve(head.parcel_count);
    for (const ParcelRecord& record : parts.next<ParcelRecord>(head.parcel_count)) {
        for (const float value :
             {record.x_m, record.y_m, record.z_m, record.volume_m3, record.coldness}) {
            if (std::isfinite(value)) continue;
            throw core::InputError("holds a parcel (number " + std::to_string(parcels.size()) +
                                   ") whose values are not finite.");
        }
        parcels.push_back(
            {{record.x_m, record.y_m, record.z_m}, record.volume_m3, record.coldness, record.ball});
    }
    return parcels;
}

}  // namespace

void write_tea_frame(const std::filesystem::path& path, const TeaFrame& frame,
                     std::uint64_t scene_hash) {
    Head head = head_of(frame, scene_hash);
    packing::Packer packer;
    std::array<Bytes, kParts> parts;
    parts[0] = packer.packed(planes_of(records_of(frame.parcels)));
    if (head.nx > 0) parts[1] = packer.packed(planes_of(interior_of(frame.dissolved)));
    if (head.has_coldness != 0) parts[2] = packer.packed(planes_of(interior_of(frame.coldness)));
    std::string file(sizeof head, '\0');
    for (std::size_t part = 0; part < kParts; ++part) {
        head.packed_bytes[part] = parts[part].size();
        file.append(reinterpret_cast<const char*>(parts[part].data()), parts[part].size());
    }
    std::memcpy(file.data(), &head, sizeof head);
    head.checksum = checksum(file);
    std::memcpy(file.data(), &head, sizeof head);
    core::write_text_file(path, file);
}

TeaFrame read_tea_frame(const std::filesystem::path& path, std::uint64_t scene_hash) {
    const std::string file = core::read_text_file(path, most_file_bytes());
    Head head;
    const std::string fault = read_head(file, scene_hash, head);
    if (!fault.empty()) throw core::InputError(path.string() + ": " + fault);
    try {
        Parts parts(file, head);
        TeaFrame frame;
        frame.time_s = head.time_s;
        frame.step = static_cast<int>(head.step);
        frame.parcels = read_parcels(head, parts);
        if (head.nx > 0) frame.dissolved = read_field(head, parts);
        if (head.has_coldness != 0) frame.coldness = read_field(head, parts);
        return frame;
    } catch (const core::InputError& error) {
        throw core::InputError(path.string() + ": " + error.what());
    }
}

bool is_whole_tea_frame(const std::filesystem::path& path, std::uint64_t scene_hash) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    Head head;
    try {
        return read_head(core::read_text_file(path, most_file_bytes()), scene_hash, head).empty();
    } catch (const core::InputError&) {
        return false;
    }
}

}  // namespace pastoso::io
