// Takes the noise out of a traced picture: a mean over pixels whose surroundings look alike within their
// noise (non-local means, Buades et al. 2005), where alike also means the same surface (Rousselle et al.
// 2013).
#pragma once

#include "core/thread_pool.hpp"
#include "trace/picture.hpp"

#include <vector>

namespace pastoso::trace {

/// What a pixel shows besides its light: colour of the first dull thing that is met, direction
/// of the first surface of all.
inline constexpr int kFeatures = 6;

struct NoisyPicture {
    Picture even, odd;  ///< independent estimates of one picture, of the same size
    /// kFeatures a pixel, of size about 1, in independent estimates too; or none.
    std::vector<float> even_features, odd_features;
};

/// The same bits on any number of threads and every instruction set.
Picture denoise(const NoisyPicture& noisy, core::ThreadPool& pool);

}  // namespace pastoso::trace
