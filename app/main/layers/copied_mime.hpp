// Paint on its way to other paintings and programs: on the system's clipboard, or dragged.
#pragma once

#include "document/actions/copy_actions.hpp"
#include "document/painting.hpp"
#include "pigment/bands.hpp"

#include <optional>

#include <QByteArray>
#include <QImage>
#include <QMimeData>

namespace pastoso::main {

/// As recordings::piece_bytes() writes it.
inline constexpr QLatin1String kPaintFormat("application/x-pastoso-paint");

/// As much as it passes on of paint: a recording holds it, too.
inline constexpr int kMostPaint_MB = 256;

/// Copied paint for whoever asks: its bytes and its picture are made when somebody does, of nothing but
/// the paint, since the window it was copied in may be gone then.
class CopiedMime : public QMimeData {
  public:
    /// `ground`: what its picture is seen on.
    CopiedMime(document::CopiedPaint paint, const pigment::Bands& ground);

    const document::CopiedPaint& paint() const { return paint_; }

    /// Besides what was set.
    QStringList formats() const override;

  protected:
    QVariant retrieveData(const QString& format, QMetaType type) const override;

  private:
    QByteArray bytes() const;
    QImage made_picture() const;

    document::CopiedPaint paint_;
    pigment::Bands ground_;
    mutable std::optional<QByteArray> bytes_;
    mutable QImage picture_;
};

/// All paint of a layer as it is in that snapshot; null where there is none. The caller's.
CopiedMime* copied_layer(const document::Snapshot& painting, document::LayerId layer);

}  // namespace pastoso::main
