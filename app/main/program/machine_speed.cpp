#include "main/program/machine_speed.hpp"

#include "core/fault.hpp"
#include "core/thread_pool.hpp"
#include "core/user_data.hpp"
#include "document/canvas.hpp"
#include "session/live_speed.hpp"
#include "tools/memory_file.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace pastoso::main {
namespace {

constexpr int kVersion = 1, kMostProcessors = 1 << 16;
constexpr double kUnmeasured_px_per_mm = 4.0;

std::filesystem::path file() {
    return core::user_state_path("machine.json");
}

std::optional<double> kept(int processors) {
    std::optional<double> px_per_mm;
    core::fault_of([&] {
        tools::read_memory(file(), kVersion, [&](const files::JsonPlace& root) {
            const auto measured_on = root.entry("processors").integer(1, kMostProcessors);
            const double finest = root.entry("live_px_per_mm").number();
            const bool possible = finest >= document::kMinPxPerMm && finest <= document::kMaxPxPerMm;
            if (measured_on == processors && possible) px_per_mm = finest;
        });
    });
    return px_per_mm;
}

}  // namespace

double live_px_per_mm() {
    core::ThreadPool pool;
    if (const auto known = kept(pool.thread_count())) return *known;
    double measured = kUnmeasured_px_per_mm;
    const core::Message fault = core::fault_of([&] {
        measured = session::live_px_per_mm(
            [&](double px_per_mm) { return session::painting_load(px_per_mm, pool); });
    });
    if (!fault.empty()) return measured;
    core::fault_of([&] {
        tools::write_memory(
            {{"version", kVersion}, {"processors", pool.thread_count()}, {"live_px_per_mm", measured}},
            file());
    });
    return measured;
}

}  // namespace pastoso::main
