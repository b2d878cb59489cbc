#include "panels/messages/wrapped_text.hpp"

#include <cmath>

#include <QPainter>
#include <QTextLayout>

namespace pastoso::panels {
namespace {

constexpr int kUsualCharacters = 60, kLeastCharacters = 16;

/// Breaks the text into lines of that width; returns how high they are.
int broken_into_lines(QTextLayout& text, int width) {
    QTextOption option(Qt::AlignLeft);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    text.setTextOption(option);
    double height = 0.0;
    text.beginLayout();
    for (QTextLine line = text.createLine(); line.isValid(); line = text.createLine()) {
        line.setLineWidth(width);
        line.setPosition(QPointF(0.0, height));
        height += line.height();
    }
    text.endLayout();
    return static_cast<int>(std::ceil(height));
}

}  // namespace

WrappedText::WrappedText(const QString& text, QWidget* parent) : QWidget(parent), text_(text) {
    setAccessibleName(text);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

int WrappedText::heightForWidth(int width) const {
    QTextLayout text(text_, font());
    return broken_into_lines(text, width);
}

QSize WrappedText::sizeHint() const {
    const int width = fontMetrics().averageCharWidth() * kUsualCharacters;
    return {width, heightForWidth(width)};
}

QSize WrappedText::minimumSizeHint() const {
    return {fontMetrics().averageCharWidth() * kLeastCharacters, fontMetrics().height()};
}

void WrappedText::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    QTextLayout text(text_, font());
    const int spare = height() - broken_into_lines(text, width());
    text.draw(&painter, QPointF(0.0, 0.5 * spare));
}

}  // namespace pastoso::panels
