// Values as they are typed on the command line.
#pragma once

#include "document/events.hpp"

#include <string>

namespace pastoso::cli {

struct CanvasSize {
    double width_mm = 0.0;
    double height_mm = 0.0;
};

/// "300x200mm", "30x20cm" or "300x200" (millimetres). Throws UsageError otherwise.
CanvasSize parse_canvas_size(const std::string& text);

/// "PB29" or "#c03020", a mixture "PB29=1+PW6=0.5" (parts by volume), either followed by "@0.3": thinned
/// to that share of paint in clear medium; "clear": the medium alone. Throws UsageError otherwise. The
/// names are not looked up.
document::PaintRecipe parse_paint(const std::string& text);

}  // namespace pastoso::cli
