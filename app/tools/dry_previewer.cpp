#include "tools/dry_previewer.hpp"

#include <utility>

namespace pastoso::tools {
namespace {

/// Takes about a tenth of a second.
constexpr int kTilesOfThread = 24;

}  // namespace

DryPreviewer::DryPreviewer(Deliver deliver, core::Tell tell)
    : deliver_(std::move(deliver)),
      worker_([this](Job& job) { find(job); },
              [tell = std::move(tell)](Job&, const core::Message& fault) { tell(fault); }) {}

void DryPreviewer::want(Job job) {
    worker_.cancel();
    worker_.add(std::move(job));
}

void DryPreviewer::find(const Job& job) {
    if (job.painting == nullptr) {
        preview_ = {};
        return;
    }
    if (job.wanted) preview(job);
    if (job.colours) deliver_({job.number, nullptr, DryColours(*job.painting)});
    while (job.wanted && !preview_.complete() && !worker_.cancelled())
        preview(job);
}

void DryPreviewer::preview(const Job& job) {
    auto seen = preview_.of(*job.painting, *job.wanted,
                            {job.seen, kTilesOfThread * pool_.thread_count()}, pool_);
    deliver_({job.number, std::make_shared<const document::Snapshot>(std::move(seen)), std::nullopt});
}

}  // namespace pastoso::tools
