// Triangles around all that is denser than a threshold: marching cubes with shared vertices.
//
// Three passes over the layers of samples, each layer on any thread. First every row becomes bits, one
// for each sample that is inside; where two bits differ lies a vertex. Then rows are counted, so that
// each knows where its vertices and triangles go. Then they are written. A vertex' number follows from
// counting bits, and rows without a surface cost a few instructions for 32 cells (after W. Schroeder, R.
// Maynard and B. Geveci, "Flying edges: a high-performance scalable isocontouring algorithm", LDAV
// 2015).
#pragma once

#include "core/isa.hpp"
#include "core/thread_pool.hpp"
#include "liquid/surface/sampled_field.hpp"
#include "liquid/surface/triangle_mesh.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::liquid {

/// What happens where the inside reaches the outermost samples: the surface ends there, with an edge, or
/// it is closed by a wall through them, as if all samples beyond were far outside.
enum class MeshBorder { Open, Closed };

struct MarchingOptions {
    MeshBorder border = MeshBorder::Closed;
    bool normals = true;
    core::Isa isa = core::best_isa();  ///< the bits are the same for all
};

/// Keeps its working memory from one surface to the next.
class MarchingCubes {
  public:
    explicit MarchingCubes(core::ThreadPool& pool) : pool_(pool) {}

    /// The surface of {value > iso}: an oriented manifold, with an edge only at an open border. A vertex
    /// lies on each lattice edge between an inner and an outer sample, where linear interpolation meets
    /// iso, but at least 1e-4 of the edge from its ends; its normal is the interpolated gradient
    /// (central differences), downwards. Values must lie within +-1e17; what is no number counts as
    /// outside. `mesh` is overwritten; its memory is used again. The same bits for any number of
    /// threads.
    void run(const SampleView& samples, float iso, const MarchingOptions& options, TriangleMesh& mesh);

  private:
    struct RowCounts {
        std::uint32_t x = 0, y = 0, z = 0;  ///< vertices on edges that begin in this row, by axis
        std::uint32_t triangles = 0;        ///< of the cells between this row and its neighbours
    };
    struct RowStart {
        std::uint32_t vertex = 0, triangle = 0;
    };
    struct Scratch {
        std::vector<float> numbers;
        std::vector<std::int32_t> places;
    };

    void mark(const SampleView& samples, float iso, core::Isa isa);
    void count(const Lattice& lattice, core::Isa isa);
    void allocate(const MarchingOptions& options, TriangleMesh& mesh);
    void place_row(const SampleView& samples, int j, int k, float iso, const MarchingOptions& options,
                   Scratch& scratch, TriangleMesh& mesh) const;
    void connect_row(const Lattice& lattice, int j, int k, core::Isa isa, TriangleMesh& mesh) const;
    SampleView padded(const SampleView& samples);
    std::size_t row_index(const Lattice& lattice, int j, int k) const {
        return static_cast<std::size_t>(k) * static_cast<std::size_t>(lattice.ny) +
               static_cast<std::size_t>(j);
    }
    const std::uint32_t* bits(std::size_t row) const { return bits_.data() + row * words_; }

    core::ThreadPool& pool_;
    SampledField padded_;
    std::size_t words_ = 0;  ///< of a row
    std::vector<std::uint32_t> bits_;
    std::vector<RowCounts> counts_;
    std::vector<RowStart> starts_;
    std::vector<Scratch> scratch_;  ///< for each thread
};

/// The same in memory of its own.
TriangleMesh marching_cubes(const SampleView& samples, float iso, core::ThreadPool& pool,
                            const MarchingOptions& options = {});

}  // namespace pastoso::liquid
