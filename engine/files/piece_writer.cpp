#include "files/piece_writer.hpp"

namespace pastoso::files {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;

}  // namespace

void PieceWriter::item_done() {
    ++done_;
    if (buffer_.size() < kPiece) return;
    flush();
    if (!keep_going_(static_cast<double>(done_) / static_cast<double>(items_))) throw Stopped{};
}

void PieceWriter::flush() {
    file_.append(buffer_);
    file_.check();
    buffer_.clear();
}

ExportStatus write_in_pieces(const std::filesystem::path& path, std::size_t items,
                             const KeepGoing& keep_going,
                             const std::function<void(PieceWriter&)>& write) {
    const bool written = core::write_aside_unless(path, [&](core::OutputFile& file) {
        PieceWriter writer(file, items, keep_going);
        try {
            write(writer);
        } catch (const PieceWriter::Stopped&) {
            return false;
        }
        writer.flush();
        return keep_going(1.0);
    });
    return written ? ExportStatus::Written : ExportStatus::Stopped;
}

}  // namespace pastoso::files
