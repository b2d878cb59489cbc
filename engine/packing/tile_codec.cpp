#include "packing/tile_codec.hpp"

#define PASTOSO_DECLARE_TILE_CODEC(isa)                                                     \
    namespace isa {                                                                         \
    void encode_tile(const std::uint32_t* words, int channels, const Expectation& expected, \
                     std::byte* out);                                                       \
    void decode_tile(const std::byte* in, int channels, const Expectation& expected,        \
                     std::uint32_t* words);                                                 \
    inline constexpr TileCodec kCodec = {encode_tile, decode_tile};                         \
    }

namespace pastoso::packing {

PASTOSO_DECLARE_TILE_CODEC(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_TILE_CODEC(avx2)
PASTOSO_DECLARE_TILE_CODEC(avx512)
#endif

const TileCodec& tile_codec([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kCodec;
    if (isa == core::Isa::Avx2) return avx2::kCodec;
#endif
    return baseline::kCodec;
}

}  // namespace pastoso::packing
