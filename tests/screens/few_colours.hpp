// Pictures of few colours, so that those of the manual stay small.
#pragma once

#include <QImage>

namespace pastoso::screens {

/// The same in 256 colours that are chosen for it.
QImage in_few_colours(const QImage& picture);

}  // namespace pastoso::screens
