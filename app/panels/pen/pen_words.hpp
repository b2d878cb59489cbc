// Pens and what they tell, in words.
#pragma once

#include "panels/pen/pen_pad.hpp"

#include <QString>

namespace pastoso::panels {

QString words_of(const tools::PenDevice& device);

/// Always two lines, so that nothing jumps.
QString words_of(const PenReading& reading);

}  // namespace pastoso::panels
