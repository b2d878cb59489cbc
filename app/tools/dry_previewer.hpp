// Makes what adjusted dry paint would look like, on a thread of its own.
#pragma once

#include "core/worker.hpp"
#include "document/adjusted_preview.hpp"
#include "tools/dry_colours.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace pastoso::tools {

class DryPreviewer {
  public:
    struct Job {
        std::shared_ptr<const document::Snapshot> painting{};
        std::optional<document::WantedAdjustment> wanted{};  ///< is previewed; none: nothing is
        grid::Rect seen{};                                   ///< cells, whose middle is previewed first
        bool colours = false;  ///< the colours of the dry paint are looked at
        int number = 0;        ///< by which whoever asked knows it again
    };

    /// One or the other of what a job asks for.
    struct Found {
        int number = 0;
        std::shared_ptr<const document::Snapshot> preview{};
        std::optional<DryColours> colours{};
    };

    /// Is called on the previewer's thread, several times a job; must return at once.
    using Deliver = std::function<void(Found found)>;

    /// `tell` hears why a preview is missing.
    DryPreviewer(Deliver deliver, core::Tell tell);

    /// Takes the place of what waits; what is under way is previewed no further.
    void want(Job job);

    /// Lets go of what it holds of the painting.
    void forget() { want({}); }

  private:
    void find(const Job& job);
    void preview(const Job& job);

    Deliver deliver_;
    core::ThreadPool pool_;
    document::AdjustedPreview preview_;
    core::Worker<Job> worker_;
};

}  // namespace pastoso::tools
