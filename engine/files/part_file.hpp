// A file of compressed parts behind a head that says what it is, to which scene it belongs and whether
// it is whole: the container of liquids' frames and checkpoints (docs/tea-cache.md).
#pragma once

#include "core/message.hpp"
#include "packing/packed_bytes.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace pastoso::files {

/// What all files of one kind have in common.
struct PartFileKind {
    core::Pattern<0> what;  ///< "frame of tea"
    std::array<char, 8> mark;
    std::uint32_t version;   ///< that is written
    std::uint32_t oldest;    ///< that is read
    std::size_t fact_bytes;  ///< of the kind's own struct in the head, a multiple of 8
    std::size_t parts;
    std::size_t most_bytes;  ///< of the parts; a larger file is not read
    /// Versions up to this one have the first so many bytes of the struct alone.
    std::uint32_t short_version = 0;
    std::size_t short_fact_bytes = 0;

    std::size_t fact_bytes_of(std::uint32_t of_version) const {
        return of_version <= short_version ? short_fact_bytes : fact_bytes;
    }
    std::size_t head_bytes(std::uint32_t of_version) const;
};

/// Packs parts one after the other; then the file is written in one piece.
class PartFileWriter {
  public:
    explicit PartFileWriter(const PartFileKind& kind) : kind_(kind) {}

    /// The next part.
    template <class Value>
    void add(std::span<const Value> values) {
        static_assert(std::is_trivially_copyable_v<Value>);
        add_bytes(std::as_bytes(values), sizeof(Value));
    }
    template <class Value>
    void add(const std::vector<Value>& values) {
        add(std::span<const Value>(values));
    }

    /// A part that is not kept: no bytes.
    void add_nothing() { parts_.emplace_back(); }

    /// Writes the file aside; all parts were added. `flags` are the kind's own. Throws InputError when
    /// it cannot be written.
    template <class Facts>
    void write(const std::filesystem::path& path, std::uint64_t scene_hash, std::uint32_t flags,
               const Facts& facts) const {
        static_assert(std::is_trivially_copyable_v<Facts> && sizeof(Facts) % 8 == 0);
        write_bytes(path, scene_hash, flags, std::as_bytes(std::span(&facts, 1)));
    }

  private:
    void add_bytes(std::span<const std::byte> values, std::size_t value_bytes);
    void write_bytes(const std::filesystem::path& path, std::uint64_t scene_hash, std::uint32_t flags,
                     std::span<const std::byte> facts) const;

    PartFileKind kind_;
    packing::Packer packer_;
    std::vector<packing::Bytes> parts_;
};

/// Reads parts one after the other.
class PartFileReader {
  public:
    /// Throws InputError "PATH: is ..." when the file cannot be read, is of no such kind, of another
    /// version, damaged, or belongs to another scene. Nothing is unpacked yet.
    PartFileReader(std::filesystem::path path, const PartFileKind& kind, std::uint64_t scene_hash);

    std::uint32_t version() const { return version_; }
    std::uint32_t flags() const { return flags_; }

    /// The kind's own struct. Its numbers are whatever was written; what an old version does not have
    /// is as the struct begins.
    template <class Facts>
    Facts facts() const {
        static_assert(std::is_trivially_copyable_v<Facts>);
        Facts facts{};
        copy_facts(std::as_writable_bytes(std::span(&facts, 1)));
        return facts;
    }

    /// The next part, which must be `count` values: no more is allocated. Throws InputError.
    template <class Value>
    std::vector<Value> next(std::size_t count) {
        static_assert(std::is_trivially_copyable_v<Value>);
        std::vector<Value> values(unpack_next(count * sizeof(Value)) / sizeof(Value));
        copy_values(std::as_writable_bytes(std::span(values)), sizeof(Value));
        return values;
    }

    /// Leaves the next part out.
    void skip();

    /// Throws InputError "PATH: SENTENCE".
    [[noreturn]] void refuse(const core::Message& sentence) const;
    template <class... Arguments>
    [[noreturn]] void refuse(core::Pattern<sizeof...(Arguments)> pattern,
                             const Arguments&... arguments) const {
        refuse(core::message(pattern, arguments...));
    }

  private:
    core::Message fault(std::uint64_t scene_hash);
    std::size_t head_bytes() const { return kind_.head_bytes(version_); }
    std::uint64_t number_at(std::size_t byte) const;
    std::uint64_t part_bytes(std::size_t part) const;
    void copy_facts(std::span<std::byte> facts) const;
    std::size_t unpack_next(std::size_t bytes);
    void copy_values(std::span<std::byte> values, std::size_t value_bytes) const;

    std::filesystem::path path_;
    PartFileKind kind_;
    std::string file_;
    std::uint32_t version_ = 0, flags_ = 0;
    std::size_t part_ = 0, next_at_ = 0;
    packing::Unpacker unpacker_;
    std::span<const std::byte> unpacked_;
};

}  // namespace pastoso::files
