// How far long work is: a bar with the time left on a terminal; elsewhere a line for every tenth, and an
// early one that says of slow work how long it will take.
#pragma once

#include <chrono>
#include <string>

namespace pastoso::cli {

class Progress {
  public:
    enum class Style { Bar, Lines, None };

    /// The style for the error stream as it is: a bar on a terminal, lines into a file or pipe.
    static Style style_for_stderr(bool quiet);

    Progress(std::string label, Style style);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `fraction` from 0 to 1. Cheap enough for every tick.
    void update(double fraction);

    /// Removes the bar; what is written next starts on a clean line.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    void draw_bar(double fraction, double elapsed_s);
    void print_line(double fraction, double elapsed_s) const;

    std::string label_;
    Style style_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_draw_ = start_;
    int next_tenth_ = 0;  ///< of which there is to be a line; 0 before the first
    bool bar_shown_ = false;
};

/// "4 s", "2 min 05 s", "1 h 02 min".
std::string duration_text(double seconds);

}  // namespace pastoso::cli
