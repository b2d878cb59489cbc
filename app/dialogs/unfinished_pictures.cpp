#include "dialogs/unfinished_pictures.hpp"

#include "core/thread_pool.hpp"

namespace pastoso::dialogs {
namespace {

/// The painting on the easel comes first.
constexpr int kNice = 10;

/// Nobody waits for the picture any more.
struct Unwanted {};

}  // namespace

UnfinishedPictures::UnfinishedPictures(QObject* parent)
    : QObject(parent),
      worker_([this](journal::Unfinished& painting) { paint(painting); },
              [](journal::Unfinished&, const core::Message&) {}, kNice) {}

void UnfinishedPictures::want(const journal::Unfinished& painting) {
    if (painting.thumbnail.empty() && painting.fault.empty()) worker_.add(painting);
}

void UnfinishedPictures::paint(journal::Unfinished& painting) {
    core::ThreadPool pool(1);
    painting.thumbnail = journal::recovered_thumbnail(painting.folder, pool, [this](double) {
        if (worker_.cancelled()) throw Unwanted();
    });
    QMetaObject::invokeMethod(
        this, [this, painting] { Q_EMIT painted(painting); }, Qt::QueuedConnection);
}

}  // namespace pastoso::dialogs
