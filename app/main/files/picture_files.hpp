// The files of pictures: those that dialogs offer, and those that are dragged or copied.
#pragma once

#include <QMimeData>
#include <QString>
#include <QStringList>
#include <QUrl>

namespace pastoso::main {

/// As a filter of a file dialog.
inline QString picture_endings() {
    return QStringLiteral(
        "*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr *.hdr *.bmp *.tga *.gif *.psd *.pgm *.ppm");
}

/// The paths of what is dragged or copied, as far as it is on this machine.
inline QStringList local_files(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) paths.push_back(url.toLocalFile());
    return paths;
}

}  // namespace pastoso::main
