// Compiled once per instruction set; see pastoso_add_kernels.
#include "core/lane_memory.hpp"
#include "liquid/surface/marching_kernels.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

constexpr int kWordBits = 32;
constexpr float kLeastShare = 1e-4F;

/// Bits of 32 values that are > iso.
PASTOSO_LANE_FUNCTION std::uint32_t word_of(const float* values, float iso) {
    using Floats = lanes::Widest<float>;
    std::uint32_t word = 0;
    for (int first = 0; first < kWordBits; first += Floats::kLanes)
        word |= lanes::mask_bits(lanes::load<Floats>(values + first) > Floats(iso)) << first;
    return word;
}

/// The bits from bit 32 w on, 64 of them.
PASTOSO_LANE_FUNCTION std::uint64_t bits_from(const std::uint32_t* words, int w) {
    return words[w] | static_cast<std::uint64_t>(words[w + 1]) << kWordBits;
}

/// 1 for the first `count` - 32 w bits, at most 32.
PASTOSO_LANE_FUNCTION std::uint32_t first_bits(int count, int w) {
    const int left = count - kWordBits * w;
    return left >= kWordBits ? ~0U : left <= 0 ? 0U : (1U << left) - 1U;
}

PASTOSO_LANE_FUNCTION std::uint32_t ones(std::uint32_t word) {
    return static_cast<std::uint32_t>(__builtin_popcount(word));
}

/// Where vertices lie on edges along x of 32 samples.
PASTOSO_LANE_FUNCTION std::uint32_t x_edges(std::uint64_t bits, int nx, int w) {
    return static_cast<std::uint32_t>(bits ^ bits >> 1) & first_bits(nx - 1, w);
}

/// Calls use(word, w) for words of bits on the row's edges.
template <class Use>
PASTOSO_LANE_FUNCTION void for_edge_words(const std::uint32_t* row, const std::uint32_t* other, int nx,
                                          const Use& use) {
    const int words = (nx + kWordBits - 1) / kWordBits;
    for (int w = 0; w < words; ++w)
        use(row == other ? x_edges(bits_from(row, w), nx, w) : row[w] ^ other[w], w);
}

/// The bits of 32 cells in the four rows around them.
struct Cells {
    std::uint64_t row[4];
    std::uint32_t active;  ///< those that the surface goes through

    PASTOSO_LANE_MEMBER unsigned corners(int i) const {
        return static_cast<unsigned>((row[0] >> i & 3) | (row[1] >> i & 3) << 2 |
                                     (row[2] >> i & 3) << 4 | (row[3] >> i & 3) << 6);
    }
};
PASTOSO_LANE_FUNCTION Cells cells_at(const CellRowBits& bits, int w) {
    Cells cells;
    std::uint64_t some = 0, all = ~std::uint64_t{0};
    for (int r = 0; r < 4; ++r) {
        cells.row[r] = bits_from(bits.row[r], w);
        some |= cells.row[r];
        all &= cells.row[r];
    }
    cells.active =
        static_cast<std::uint32_t>((some | some >> 1) & ~(all & all >> 1)) & first_bits(bits.nx - 1, w);
    return cells;
}

/// Numbers of vertices on edges of one row in one direction: that of the first one of the word, and
/// bits.
struct EdgeNumbers {
    std::uint32_t first;
    std::uint64_t edges = 0;

    PASTOSO_LANE_MEMBER std::uint32_t before(int i) const {
        return first + ones(static_cast<std::uint32_t>(edges) & ((1U << i) - 1U));
    }
    PASTOSO_LANE_MEMBER std::uint32_t bit(int i) const {
        return static_cast<std::uint32_t>(edges >> i) & 1U;
    }
    PASTOSO_LANE_MEMBER void next_word() { first += ones(static_cast<std::uint32_t>(edges)); }
};

/// The numbers of the vertices around a row of cells.
struct CellNumbers {
    EdgeNumbers x[4], y[2], z[2];

    PASTOSO_LANE_MEMBER void start_word(const Cells& cells, int nx, int w) {
        for (int r = 0; r < 4; ++r)
            x[r].edges = x_edges(cells.row[r], nx, w);
        y[0].edges = cells.row[0] ^ cells.row[1];
        y[1].edges = cells.row[2] ^ cells.row[3];
        z[0].edges = cells.row[0] ^ cells.row[2];
        z[1].edges = cells.row[1] ^ cells.row[3];
    }
    PASTOSO_LANE_MEMBER void end_word() {
        for (EdgeNumbers& numbers : x)
            numbers.next_word();
        for (int r = 0; r < 2; ++r) {
            y[r].next_word();
            z[r].next_word();
        }
    }
    /// In the order of cube_edge().
    PASTOSO_LANE_MEMBER void of_cell(int i, std::uint32_t* numbers) const {
        for (int r = 0; r < 4; ++r)
            numbers[r] = x[r].before(i);
        for (int r = 0; r < 2; ++r) {
            numbers[4 + 2 * r] = y[r].before(i);
            numbers[5 + 2 * r] = numbers[4 + 2 * r] + y[r].bit(i);
            numbers[8 + 2 * r] = z[r].before(i);
            numbers[9 + 2 * r] = numbers[8 + 2 * r] + z[r].bit(i);
        }
    }
};

struct Slope {
    float x, y, z;
};
/// Differences of samples two apart, at one end of an edge; the same sample where there is none.
PASTOSO_LANE_FUNCTION Slope slope_at(const EdgeRow& edges, const float* row, int end, std::int32_t i) {
    const std::int32_t last = edges.nx - 1;
    const std::int32_t low = i > 0 ? i - 1 : 0, high = i < last ? i + 1 : last;
    const float scale = high - low < 2 ? 2.0F : 1.0F;
    return {(row[high] - row[low]) * scale,
            (row[i + edges.high_y[end]] - row[i + edges.low_y[end]]) * edges.scale_y[end],
            (row[i + edges.high_z[end]] - row[i + edges.low_z[end]]) * edges.scale_z[end]};
}

/// How far along the edge the value is iso, away from both ends; what is no number becomes the least.
PASTOSO_LANE_FUNCTION float share_at(float near, float far, float iso) {
    const float share = (iso - near) / (far - near);
    const float enough = share > kLeastShare ? share : kLeastShare;
    return enough < 1.0F - kLeastShare ? enough : 1.0F - kLeastShare;
}

void place_normals(const EdgeRow& edges, const std::int32_t* places, int count,
                   const VertexColumns& out) {
    constexpr float kLeastSquare = 1e-30F;  // below it the gradient says nothing: then along the edge
    const bool along_x = edges.axis == 0;
    const float* far_row = edges.values + (along_x ? 0 : edges.along);
    const std::int32_t far_step = along_x ? 1 : 0;
    const float axis_x = along_x ? 1.0F : 0.0F, axis_y = edges.axis == 1 ? 1.0F : 0.0F,
                axis_z = edges.axis == 2 ? 1.0F : 0.0F;
    for (int n = 0; n < count; ++n) {
        const std::int32_t i = places[n];
        const Slope near = slope_at(edges, edges.values, 0, i);
        const Slope far = slope_at(edges, far_row, 1, i + far_step);
        const float share = out.share[n];
        const float x = near.x + share * (far.x - near.x);
        const float y = near.y + share * (far.y - near.y);
        const float z = near.z + share * (far.z - near.z);
        const float square = x * x + y * y + z * z;
        const float inverse = -1.0F / __builtin_sqrtf(square);
        const float outwards = edges.values[i] > edges.iso ? 1.0F : -1.0F;
        const bool steep = square > kLeastSquare;
        out.normal[0][n] = steep ? x * inverse : axis_x * outwards;
        out.normal[1][n] = steep ? y * inverse : axis_y * outwards;
        out.normal[2][n] = steep ? z * inverse : axis_z * outwards;
    }
}

}  // namespace

void mark(const float* values, int count, float iso, std::uint32_t* words) {
    int i = 0;
    for (; i + kWordBits <= count; i += kWordBits)
        *words++ = word_of(values + i, iso);
    std::uint32_t word = 0;
    for (int bit = 0; i + bit < count; ++bit)
        word |= static_cast<std::uint32_t>(values[i + bit] > iso) << bit;
    if (i < count) *words++ = word;
    *words = 0;
}

int compute_edges(const std::uint32_t* row, const std::uint32_t* other, int nx, std::int32_t* places) {
    int count = 0;
    for_edge_words(row, other, nx, [&](std::uint32_t word, int w) {
        for (; word != 0; word &= word - 1)
            places[count++] = kWordBits * w + __builtin_ctz(word);
    });
    return count;
}

std::uint32_t count_edges(const std::uint32_t* row, const std::uint32_t* other, int nx) {
    std::uint32_t count = 0;
    for_edge_words(row, other, nx, [&](std::uint32_t word, int) { count += ones(word); });
    return count;
}

std::uint32_t count_triangles(const CellRowBits& bits, const CubeCase* table) {
    std::uint32_t count = 0;
    for (int w = 0; kWordBits * w < bits.nx - 1; ++w) {
        const Cells cells = cells_at(bits, w);
        for (std::uint32_t left = cells.active; left != 0; left &= left - 1)
            count += table[cells.corners(__builtin_ctz(left))].triangle_count;
    }
    return count;
}

void place(const EdgeRow& edges, const std::int32_t* places, int count, bool normals,
           const VertexColumns& out) {
    const float* far_values = edges.values + edges.along;
    for (int n = 0; n < count; ++n)
        out.share[n] = share_at(edges.values[places[n]], far_values[places[n]], edges.iso);
    float step[3] = {};
    step[edges.axis] = 1.0F;
    for (int n = 0; n < count; ++n) {
        const float x = static_cast<float>(places[n]) + step[0] * out.share[n];
        out.position[0][n] = edges.origin_m[0] + edges.spacing_m * x;
        out.position[1][n] = edges.origin_m[1] + edges.spacing_m * (step[1] * out.share[n]);
        out.position[2][n] = edges.origin_m[2] + edges.spacing_m * (step[2] * out.share[n]);
    }
    if (normals) place_normals(edges, places, count, out);
}

void connect(const CellRowBits& bits, const CellRowVertices& vertices, const CubeCase* table,
             std::uint32_t* out) {
    CellNumbers numbers;
    for (int r = 0; r < 4; ++r)
        numbers.x[r].first = vertices.x[r];
    for (int r = 0; r < 2; ++r) {
        numbers.y[r].first = vertices.y[r];
        numbers.z[r].first = vertices.z[r];
    }
    for (int w = 0; kWordBits * w < bits.nx - 1; ++w) {
        const Cells cells = cells_at(bits, w);
        numbers.start_word(cells, bits.nx, w);
        for (std::uint32_t left = cells.active; left != 0; left &= left - 1) {
            const int i = __builtin_ctz(left);
            std::uint32_t of_edge[12];
            numbers.of_cell(i, of_edge);
            const CubeCase& cube = table[cells.corners(i)];
            const std::uint8_t* edges = cube.edges;
            for (int c = 0; c < 3 * cube.triangle_count; ++c)
                *out++ = of_edge[edges[c]];
        }
        numbers.end_word();
    }
}

}  // namespace pastoso::liquid::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::liquid, MarchingKernels, mark, compute_edges, count_edges,
                         count_triangles, place, connect)
