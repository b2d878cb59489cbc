// Canvases whose support may be a height image of the user's own.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"

#include <memory>

namespace pastoso::recordings {

/// The relief of a height image when the settings leave it open.
inline constexpr double kImageRelief_mm = 0.5;

/// The heights of the support that the settings name; for "image" those of the grey image
/// `settings.support_image`. Throws InputError when the canvas does not fit into memory, the support is
/// unknown or its image cannot be read.
film::SupportHeights make_support(const document::CanvasSettings& settings, core::ThreadPool& pool);

/// A painting on make_support().
std::unique_ptr<document::Painting> make_painting(const document::CanvasSettings& settings,
                                                  core::ThreadPool& pool);

}  // namespace pastoso::recordings
