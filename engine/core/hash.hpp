// A running 64-bit FNV-1a hash: names a state or a picture in one number, so that runs can be compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace pastoso::core {

class Hash64 {
  public:
    /// Adds the bytes of a sequence of plain values; eight bytes at a time, the rest one by one.
    template <class T>
    void add(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
        std::size_t count = values.size_bytes();
        for (; count >= 8; bytes += 8, count -= 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes, 8);
            mix(word);
        }
        for (; count > 0; ++bytes, --count) mix(*bytes);
    }

    template <class T>
    void add_value(const T& value) {
        add(std::span<const T>(&value, 1));
    }

    std::uint64_t value() const { return state_; }

    /// Sixteen hexadecimal digits.
    std::string hex() const {
        static constexpr char kDigits[] = "0123456789abcdef";
        std::string text(16, '0');
        for (int i = 0; i < 16; ++i) text[15 - i] = kDigits[(state_ >> (4 * i)) & 15U];
        return text;
    }

  private:
    void mix(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x100000001b3ULL;
        state_ ^= state_ >> 29;
    }

    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace pastoso::core
