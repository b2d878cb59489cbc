#include "cli/progress.hpp"

#include "core/printable.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace pastoso::cli {
namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kDrawInterval{100};

/// Too early, the rest of the work cannot be told from its beginning: after this share of it, or less
/// when that took so long already.
constexpr double kKnownFraction = 0.02, kKnownSlowFraction = 0.002, kSlow_s = 2.0;

bool is_slow(double fraction, double elapsed_s) {
    return fraction >= kKnownSlowFraction && elapsed_s >= kSlow_s;
}

std::string time_left(double fraction, double elapsed_s) {
    if (fraction < kKnownFraction && !is_slow(fraction, elapsed_s)) return "";
    return duration_text(elapsed_s * (1.0 - fraction) / fraction) + " left";
}

}  // namespace

std::string duration_text(double seconds) {
    const long whole = std::lround(std::max(0.0, seconds));
    char text[48];
    if (whole < 60) {
        std::snprintf(text, sizeof text, "%ld s", whole);
    } else if (whole < 3600) {
        std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole / 60 % 60);
    }
    return text;
}

Progress::Style Progress::style_for_stderr(bool quiet) {
    if (quiet) return Style::None;
    return ::isatty(STDERR_FILENO) != 0 ? Style::Bar : Style::Lines;
}

Progress::Progress(std::string label, Style style) : label_(core::printable(label)), style_(style) {}

Progress::~Progress() {
    clear();
}

void Progress::update(double fraction) {
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
    if (style_ == Style::Bar && Clock::now() >= next_draw_) {
        next_draw_ = Clock::now() + kDrawInterval;
        draw_bar(fraction, elapsed_s);
    }
    const bool foretells = next_tenth_ == 0 && is_slow(fraction, elapsed_s);
    if (style_ == Style::Lines && (foretells || fraction * 10.0 >= std::max(1, next_tenth_))) {
        next_tenth_ = static_cast<int>(fraction * 10.0) + 1;
        print_line(fraction, elapsed_s);
    }
}

void Progress::print_line(double fraction, double elapsed_s) const {
    const std::string left = fraction < 1.0 ? time_left(fraction, elapsed_s) : "";
    std::fprintf(stderr, "%s: %d %%%s%s\n", label_.c_str(), static_cast<int>(fraction * 100.0),
                 left.empty() ? "" : ", ", left.c_str());
}

void Progress::draw_bar(double fraction, double elapsed_s) {
    const int filled = static_cast<int>(fraction * kBarWidth);
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '-');
    std::fprintf(stderr, "\r\033[K%s [%s] %3d %%  %s", label_.c_str(), bar.c_str(),
                 static_cast<int>(fraction * 100.0), time_left(fraction, elapsed_s).c_str());
    std::fflush(stderr);
    bar_shown_ = true;
}

void Progress::clear() {
    if (!bar_shown_) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    bar_shown_ = false;
}

}  // namespace pastoso::cli
