// How paintings that were left unfinished are shown to the painter.
#pragma once

#include "journal/recovery.hpp"

#include <QPixmap>
#include <QString>

namespace pastoso::dialogs {

/// "A painting without a name" where it has no file.
QString unfinished_name(const journal::Unfinished& painting);

/// Lines of its name, when it was painted last, its size and what is not saved.
QString unfinished_words(const journal::Unfinished& painting);

/// In the middle of a square, so that the texts of all rows stand in line.
QPixmap unfinished_picture(const journal::Unfinished& painting, int side_px, double pixel_ratio = 1.0);

}  // namespace pastoso::dialogs
