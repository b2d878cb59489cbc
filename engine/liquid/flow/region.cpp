#include "liquid/flow/region.hpp"

#include <utility>

namespace pastoso::liquid {

Region::Region(VelocityField open) : open_(std::move(open)), open_cells_(shape()) {
    for (RowRanges& rows : rows_)
        rows = RowRanges(shape());
    compute_face_rows();
    compute_open_cells();
}

void Region::compute_face_rows() {
    for (const int axis : kAxes)
        for (int k = 0; k < shape().nz; ++k)
            for (int j = 0; j < shape().ny; ++j)
                for (int i = 0; i < shape().nx; ++i)
                    if (open_.along(axis).at(i, j, k) > 0.0F)
                        rows_[static_cast<std::size_t>(axis)].include(i, j, k);
}

void Region::compute_open_cells() {
    RowRanges& rows = rows_[static_cast<std::size_t>(Location::Cell)];
    for (int k = 0; k < shape().nz; ++k)
        for (int j = 0; j < shape().ny; ++j)
            for (int i = 0; i < shape().nx; ++i) {
                const float sum = open_.x.at(i, j, k) + open_.x.at(i + 1, j, k) + open_.y.at(i, j, k) +
                                  open_.y.at(i, j + 1, k) + open_.z.at(i, j, k) +
                                  open_.z.at(i, j, k + 1);
                if (!(sum > 0.0F)) continue;
                open_cells_.at(i, j, k) = 1.0F;
                rows.include(i, j, k);
                ++open_cell_count_;
            }
}

}  // namespace pastoso::liquid
