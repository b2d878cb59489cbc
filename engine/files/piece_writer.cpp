#include "files/piece_writer.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"

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
    stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
}

bool PieceWriter::finish() {
    flush();
    stream_.flush();
    return static_cast<bool>(stream_);
}

ExportStatus write_in_pieces(const std::filesystem::path& path, std::size_t items,
                             const KeepGoing& keep_going,
                             const std::function<void(PieceWriter&)>& write) {
    const bool written = core::write_aside_unless(path, [&](const std::filesystem::path& temporary) {
        PieceWriter writer(temporary, items, keep_going);
        try {
            write(writer);
        } catch (const PieceWriter::Stopped&) {
            return false;
        }
        if (!writer.finish())
            throw core::InputError(path.string() + ": cannot be written (the disk may be full).");
        return keep_going(1.0);
    });
    return written ? ExportStatus::Written : ExportStatus::Stopped;
}

}  // namespace pastoso::files
