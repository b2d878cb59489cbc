// A picture as it is seen with half-closed eyes: its large shapes, lights and darks, without details.
#pragma once

#include "core/thread_pool.hpp"

#include <vector>

#include <QImage>

class QWidget;

namespace pastoso::screen {

/// The standard deviation of the blur on the screen, mm: what is finer than twice that is gone.
inline constexpr double kSquintBlur_mm = 2.0;

/// The share of contrast that is left: encoded values come so much nearer to the middle grey.
inline constexpr double kSquintContrast = 0.75;

/// The blur is made of squares of so many pixels a side, which no eye would tell from single ones.
inline constexpr int kSquintSquare_px = 4;

/// The blur in pixels of this widget's screen; 0 while nobody squints.
double squint_px(const QWidget& widget);

/// Weights of a normal distribution over squares, the middle one first, then those to one side; with
/// those to the other their sum is 1. Less than what squares and the interpolation between them blur by
/// themselves, which is nearly 2 pixels, is none.
std::vector<float> squint_weights(double blur_px);

/// Encoded light, 16 bits a channel (QImage::Format_RGBA64), blurred as light, not as encoded values,
/// and with less contrast; so is the share that alpha stands for, which keeps its contrast. The edge's
/// pixels go on beyond it. As kSquintGather and the shaders after it do it.
QImage squinted(const QImage& picture, double blur_px, core::ThreadPool& pool);

}  // namespace pastoso::screen
