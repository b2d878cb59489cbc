#include "cli/info.hpp"

#include "brush/preset.hpp"
#include "cli/paint_info.hpp"
#include "cli/printing.hpp"
#include "cli/progress.hpp"
#include "cli/recording_source.hpp"
#include "cli/usage_error.hpp"
#include "core/isa.hpp"
#include "core/number_text.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "document/canvas.hpp"
#include "files/image.hpp"
#include "film/medium.hpp"
#include "film/support/support.hpp"
#include "pigment/palette.hpp"
#include "project/project.hpp"
#include "recordings/recording_json.hpp"
#include "recordings/recording_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <thread>

namespace pastoso::cli {
namespace {

using core::number_text;

void print_program() {
    print("pastoso-cli %s, %s build by %s\n", core::version(), PASTOSO_BUILD_TYPE, PASTOSO_COMPILER);
    print("instruction set %s, %u processors\n", core::name_of(core::best_isa()),
          std::thread::hardware_concurrency());
    print("\nBrushes:\n");
    for (const brush::Preset& preset : brush::bundled_presets()) {
        print("  %-24s %s, %s mm wide\n", preset.name.c_str(),
              std::string(name_of(preset.tip.shape)).c_str(), number_text(preset.tip.width_mm).c_str());
    }
    print("\nPigments:\n");
    for (const pigment::Pigment& pigment : pigment::bundled_palette()) {
        print("  %-10s %s\n", pigment.ci_name.c_str(), pigment.name.c_str());
    }
    print("\nMedia:\n");
    for (const film::Medium& medium : film::bundled_media()) {
        print("  %-20s %s\n", medium.name.c_str(), medium.description.c_str());
    }
    print("\nLights:\n  D65, D50, A, LED, or the path of a CSV file\n");
    print("\nSupports:\n  %s, or the path of a height image\n",
          core::listed(film::support_names()).c_str());
}

std::string paint_text(const document::PaintRecipe& paint) {
    if (paint.ingredients.empty()) return "clear";
    std::string text;
    for (const document::Ingredient& ingredient : paint.ingredients) {
        if (!text.empty()) text += "+";
        text += ingredient.pigment + "=" + number_text(ingredient.parts);
    }
    return paint.strength == 1.0 ? text : text + "@" + number_text(paint.strength);
}

/// What a recording uses, every name once, in alphabetical order.
struct Inventory {
    std::set<std::string> brushes, paints, media;
    long strokes = 0, well_strokes = 0, squeezes = 0;

    void operator()(const document::TakeBrush& take) { brushes.insert(take.preset); }
    void operator()(const document::LayBrushAside& lay) { (*this)(lay.brush); }
    void operator()(const document::LoadPaint& load) {
        paints.insert(paint_text(load.paint));
        if (!load.second.ingredients.empty()) paints.insert(paint_text(load.second));
    }
    void operator()(const document::UseMedium& medium) { media.insert(medium.name); }
    void operator()(const document::SqueezePaint& squeeze) {
        paints.insert(paint_text(squeeze.paint));
        ++squeezes;
    }
    void operator()(const document::FillWithPaint& fill) {
        paints.insert(paint_text(fill.paint));
        if (!fill.line.empty()) paints.insert(paint_text(fill.second));
    }
    void operator()(const document::ToneGround& tone) { paints.insert(paint_text(tone.paint)); }
    void operator()(const document::LayTexture& lay) { paints.insert(paint_text(lay.paint)); }
    void operator()(const document::AdjustDryPaint& adjust) { paints.insert(paint_text(adjust.paint)); }
    void operator()(const document::PenDown& pen) {
        ++strokes;
        well_strokes += pen.surface == document::Surface::Well ? 1 : 0;
    }
    template <class Other>
    void operator()(const Other&) {}
};

void print_names(const char* what, const std::set<std::string>& names) {
    print("%s:", what);
    for (const std::string& name : names)
        print(" %s%s", name.c_str(), name == *names.rbegin() ? "" : ",");
    print("\n");
}

void print_canvas(const document::CanvasSettings& canvas) {
    const grid::Shape shape = document::canvas_shape(canvas);
    print("canvas: %s x %s mm, %s, %s px/mm (%d x %d cells)\n", number_text(canvas.width_mm).c_str(),
          number_text(canvas.height_mm).c_str(), canvas.support.c_str(),
          number_text(canvas.px_per_mm).c_str(), shape.width, shape.height);
}

std::string time_text(std::int64_t ticks) {
    return duration_text(static_cast<double>(ticks) * document::kTick_s);
}

/// The painting is read for it: a damaged one is told of here.
void print_state(const std::string& path) {
    core::ThreadPool pool;
    const project::LoadedProject project = project::load_project(path, pool);
    print("state: %016llx\n", static_cast<unsigned long long>(document::state_hash(project.painting)));
    for (const core::Message& note : project.notes)
        print("note: %s\n", note.text().c_str());
}

void print_project(const std::string& path) {
    const project::ProjectSummary summary = project::project_summary(path);
    print("%s: painting, saved by Pastoso %s\n", path.c_str(), summary.program.c_str());
    print_canvas(summary.canvas);
    print("painted for: %s\n", time_text(summary.tick).c_str());
    print("medium: %s\nbrush: %s\n", summary.medium.c_str(),
          summary.brush.empty() ? "none" : summary.brush.c_str());
    for (const project::KindSize& size : summary.sizes) {
        print("%s: %.2f MB in %.2f MB\n", size.kind.c_str(), 1e-6 * static_cast<double>(size.bytes),
              1e-6 * static_cast<double>(size.packed_bytes));
    }
    print_state(path);
}

void print_json_recording(const std::string& path) {
    const document::Recording recording = recordings::read_recording_json(path);
    Inventory inventory;
    for (const document::Event& event : recording.events)
        std::visit(inventory, event.action);
    print("%s: stroke recording\n", path.c_str());
    print_canvas(recording.canvas);
    print("duration: %s\n", time_text(recording.end_tick).c_str());
    if (recording.arithmetic != document::kArithmetic)
        print("note: its strokes %s\n", document::arithmetic_note(recording.arithmetic).text().c_str());
    print("events: %zu\nstrokes: %ld\n", recording.events.size(), inventory.strokes);
    if (inventory.well_strokes + inventory.squeezes > 0) {
        print("mixing well: %ld of the strokes, paint squeezed %ld times\n", inventory.well_strokes,
              inventory.squeezes);
    }
    print_names("brushes", inventory.brushes);
    print_names("paints", inventory.paints);
    print_names("media", inventory.media);
}

void print_pen_trace(const std::string& path) {
    const recordings::PenTrace trace = recordings::read_pen_trace(path);
    std::size_t samples = 0;
    double strongest = 0.0;
    for (const auto& stroke : trace.strokes) {
        samples += stroke.size();
        for (const brush::PenSample& sample : stroke)
            strongest = std::max(strongest, sample.pressure);
    }
    print("%s: pen recording in four columns\n", path.c_str());
    print("duration: %s\n", duration_text(trace.strokes.back().back().time_s).c_str());
    print("samples: %zu\nstrokes: %zu\n", samples, trace.strokes.size());
    print("strongest pressure: %s\n", number_text(strongest).c_str());
}

bool names_an_image(const std::string& path) {
    static constexpr std::array<const char*, 14> kExtensions = {".png", ".tif", ".tiff", ".jpg", ".jpeg",
                                                                ".exr", ".bmp", ".tga",  ".hdr", ".webp",
                                                                ".pgm", ".ppm", ".gif",  ".psd"};
    const std::string extension = std::filesystem::path(path).extension().string();
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

void print_image(const std::string& path) {
    const files::GreyImage image = files::read_grey_image(path);
    const auto [darkest, lightest] = std::minmax_element(image.values.begin(), image.values.end());
    print("%s: image\nsize: %d x %d pixels\ngrey values: %.3f to %.3f\n", path.c_str(), image.width,
          image.height, static_cast<double>(*darkest), static_cast<double>(*lightest));
}

void print_file(const std::string& path) {
    if (names_an_image(path) || files::holds_picture(path))
        print_image(path);
    else if (project::is_project_path(path))
        print_project(path);
    else if (is_json_recording(path))
        print_json_recording(path);
    else
        print_pen_trace(path);
}

}  // namespace

void run_info(const InfoOptions& options) {
    if (options.about.empty()) {
        print_program();
        return;
    }
    const std::string& subject = options.about.front();
    const auto rest = std::span(options.about).subspan(1);
    const auto expect = [&](bool right, const char* form) {
        if (!right) throw UsageError(std::string("it is: pastoso-cli info ") + form + ".");
    };
    if (subject == "paints") {
        expect(rest.empty(), "paints");
        print_paints();
    } else if (subject == "paint") {
        expect(rest.size() == 1, "paint PB29");
        print_paint(rest.front());
    } else if (subject == "closest") {
        expect(!rest.empty(), "closest \"#7a5c3e\" [PAINT...]");
        print_closest(rest.front(), rest.subspan(1));
    } else if (subject == "palette") {
        expect(rest.size() == 1, "palette FILE.gpl");
        print_palette(rest.front());
    } else {
        expect(rest.empty(), "FILE");
        print_file(subject);
    }
}

}  // namespace pastoso::cli
