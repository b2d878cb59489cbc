// What the paint lies on: woven or smooth supports, or a height image, as c(x, y) in millimetres.
//
// Heights are the same on any number of threads.
#pragma once

#include "core/thread_pool.hpp"
#include "film/support/support_heights.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pastoso::film {

/// How heights are rounded down.
enum class SupportForm {
    Levels,  ///< to levels of finest_level_mm(relief_mm): 1 to 2 nm for the weaves and the panel
    Fine,    ///< to kSupportQuantum_mm, as floats: what paintings of project format 1 and 2 lie on
};

/// A primed plain weave: every thread goes over one crossing thread and under the next. Warp threads run
/// along y, weft threads along x.
struct Weave {
    double thread_pitch_mm = 0.85;  ///< distance of neighbouring threads, of the warp; 0.1 to 5
    double relief_mm = 0.11;        ///< from the holes to the crowns, 0 to 1
    double irregularity = 1.0;      ///< of thread width and course, 0 (machine-made) to 2
    double thread_width = 0.9;  ///< share of the pitch that a thread fills, 0.5 (gauze) to 1.2 (dense)
    double pairing = 0.0;       ///< how far neighbouring warp threads draw together, 0 to 0.2 pitches
    double weft_pitch = 1.0;    ///< of the weft, in those of the warp; 0.5 to 2
    double drift = 0.0;         ///< how far the spacing comes and goes over some 25 threads, 0 to 0.1
    double unevenness = 0.0;    ///< of a thread's width along itself, 0 to 0.3
    double slubs_per_m = 0.0;   ///< thick places of 5 to 40 mm, in a metre of thread; 0 to 2
    double twist = 0.0;         ///< depth of the furrows between a thread's plies, 0 to 0.3 crowns
    double nap = 0.0;           ///< height of loose fibres, 0 to 0.2 crowns
    /// Threads finer than two cells are there as their mean, and gain their relief up to four cells: no
    /// lattice of dots is left of them.
    bool averaged = false;
};

/// Where a canvas lies on a cloth that goes on in all directions: the cell of the cloth that is the
/// canvas's first.
struct ClothPlace {
    int x0 = 0, y0 = 0;
};

/// Heights of a weave, from 0 at the holes to at most `relief_mm`: means over the cells of a function of
/// millimetres alone, so that any resolution shows the same cloth.
SupportHeights woven_support(grid::Shape shape, double cell_mm, const Weave& weave,
                             core::ThreadPool& pool, SupportForm form = SupportForm::Levels,
                             const ClothPlace& place = {});

/// How gesso was brushed on.
enum class GessoCoats {
    One,     ///< from left to right
    Crossed  ///< and a second coat across it, with a broader brush
};

/// A smooth panel with a tooth of gesso, from 0 to at most `relief_mm`; a function of millimetres, like
/// the weaves.
SupportHeights panel_support(grid::Shape shape, double cell_mm, double relief_mm, GessoCoats coats,
                             core::ThreadPool& pool, SupportForm form = SupportForm::Levels,
                             const ClothPlace& place = {});

/// A grey image stretched over the canvas: 0 is height 0, 1 is `relief_mm`. `grey` has width * height
/// values in [0, 1], row by row. Resampled by the cubic B-spline through its values, clamped to [0,
/// relief_mm], in levels.
SupportHeights image_support(grid::Shape shape, const std::vector<float>& grey, int width, int height,
                             double relief_mm, core::ThreadPool& pool);

/// The same in the fine form.
SupportHeights image_heights(grid::Shape shape, const std::vector<float>& grey, int width, int height,
                             double relief_mm);

/// The names of supports, as painters and makers of canvas use them.
const std::vector<std::string>& support_names();

/// One of these, in any case, with the relief given, or its own when `relief_mm` is 0. "linen" (a coarse
/// even weave), "cotton duck" and "panel" never change. Throws InputError that lists the names there
/// are.
SupportHeights named_support(std::string_view name, grid::Shape shape, double cell_mm, double relief_mm,
                             core::ThreadPool& pool, SupportForm form = SupportForm::Levels,
                             const ClothPlace& place = {});

/// The form in which a support that has a name was made.
SupportForm form_of(const SupportHeights& named_mm);

}  // namespace pastoso::film
