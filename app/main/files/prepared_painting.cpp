#include "main/files/prepared_painting.hpp"

#include "core/disk.hpp"
#include "core/error.hpp"
#include "core/fault.hpp"
#include "recordings/canvas_support.hpp"

#include <utility>

namespace pastoso::main {
namespace {

/// What a painting begins with is not copied in vain every other second.
void check_room(const std::filesystem::path& root) {
    constexpr std::uint64_t kLeast_bytes = 4 << 20;
    if (core::free_bytes(root).value_or(kLeast_bytes) < kLeast_bytes)
        throw core::InputError("%1: the disk is full.", root.string());
}

}  // namespace

PreparedPainting::PreparedPainting(MadePainting painting, journal::Beginning beginning,
                                   const JournalTerms& terms)
    : made(std::move(painting)), journal_number(terms.number) {
    if (terms.root.empty()) return;
    beginning.canvas = made.painting->settings();
    beginning.tick = made.painting->tick();
    begin_journal = [root = terms.root, told = terms.told, beginning = std::move(beginning)] {
        if (beginning.write_start) check_room(root);
        auto begun = std::make_unique<journal::JournalWriter>(root, beginning, journal::Pace{}, told);
        told({});
        return begun;
    };
    journal_fault = core::fault_of([this] { journal = begin_journal(); });
}

PreparedPainting::~PreparedPainting() {
    if (journal) journal->discard();
}

MadePainting made_of(const document::PaintingState& painting, document::Recording past,
                     std::unique_ptr<core::ThreadPool> pool) {
    auto made = std::make_unique<document::Painting>(painting, *pool);
    return {std::move(pool), std::move(made), std::move(past)};
}

MadePainting bare_painting(const document::CanvasSettings& canvas) {
    auto pool = std::make_unique<core::ThreadPool>();
    auto painting = recordings::make_painting(canvas, *pool);
    return {std::move(pool), std::move(painting)};
}

/// What it throws is for whoever takes it.
FirstCanvas::FirstCanvas(const document::CanvasSettings& canvas)
    : make_([canvas] { return bare_painting(canvas); }),
      made_(make_.get_future()),
      thread_([this] { make_(); }, [](const core::Message&) {}) {}

}  // namespace pastoso::main
