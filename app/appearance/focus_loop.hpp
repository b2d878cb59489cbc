// The Tab key within a part of the window that lies over the others.
#pragma once

class QWidget;

namespace pastoso::appearance {

/// Gives the keys to the next widget of `part` that takes them by Tab, or to the one before; after the
/// last comes the first. False where there is none.
bool focus_within(QWidget& part, bool next);

}  // namespace pastoso::appearance
