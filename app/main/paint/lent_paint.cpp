#include "main/paint/lent_paint.hpp"

#include <QCoreApplication>

namespace pastoso::main {

bool paint_is_lent(Studio& studio) {
    if (!studio.easel().brush_is_lent()) return false;
    studio.report(QCoreApplication::translate(
        "pastoso::main", "A recording is being played; the paint is yours when it has ended."));
    return true;
}

}  // namespace pastoso::main
