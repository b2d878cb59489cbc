#include "liquid/surface/marching_kernels.hpp"

#define PASTOSO_DECLARE_MARCHING_KERNELS(isa)                                                      \
    namespace isa {                                                                                \
    void mark(const float* values, int count, float iso, std::uint32_t* words);                    \
    int compute_edges(const std::uint32_t* row, const std::uint32_t* other, int nx,                \
                      std::int32_t* places);                                                       \
    std::uint32_t count_edges(const std::uint32_t* row, const std::uint32_t* other, int nx);       \
    std::uint32_t count_triangles(const CellRowBits& cells, const CubeCase* table);                \
    void place(const EdgeRow& edges, const std::int32_t* places, int count, bool normals,          \
               const VertexColumns& out);                                                          \
    void connect(const CellRowBits& cells, const CellRowVertices& vertices, const CubeCase* table, \
                 std::uint32_t* out);                                                              \
    inline constexpr MarchingKernels kMarchingKernels = {                                          \
        mark, compute_edges, count_edges, count_triangles, place, connect};                        \
    }

namespace pastoso::liquid {

PASTOSO_DECLARE_MARCHING_KERNELS(baseline)
#ifdef PASTOSO_MULTIPLE_ISAS
PASTOSO_DECLARE_MARCHING_KERNELS(avx2)
PASTOSO_DECLARE_MARCHING_KERNELS(avx512)
#endif

const MarchingKernels& marching_kernels([[maybe_unused]] core::Isa isa) {
#ifdef PASTOSO_MULTIPLE_ISAS
    if (isa == core::Isa::Avx512) return avx512::kMarchingKernels;
    if (isa == core::Isa::Avx2) return avx2::kMarchingKernels;
#endif
    return baseline::kMarchingKernels;
}

}  // namespace pastoso::liquid
