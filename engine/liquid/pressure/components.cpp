#include "liquid/pressure/components.hpp"

#include <algorithm>

namespace pastoso::liquid {
namespace {

/// Labels of which some mean the same component: each points to one that is not larger.
class Labels {
  public:
    int add() {
        parents_.push_back(static_cast<int>(parents_.size()));
        open_.push_back(0);
        return parents_.back();
    }
    int root(int label) {
        while (parent(label) != label) {
            parent(label) = parent(parent(label));
            label = parent(label);
        }
        return label;
    }
    int join(int a, int b) {
        const int first = root(a), second = root(b), low = std::min(first, second);
        parent(std::max(first, second)) = low;
        return low;
    }
    void mark_open(int label) { open_[static_cast<std::size_t>(label)] = 1; }

    /// The numbers from 1 of closed components, in the order of their first cells, and 0 of open ones.
    std::vector<int> numbers(int& count) {
        const int labels = static_cast<int>(parents_.size());
        for (int label = 0; label < labels; ++label)
            if (open_[static_cast<std::size_t>(label)] != 0) mark_open(root(label));
        std::vector<int> numbers(parents_.size(), 0);
        for (int label = 1; label < labels; ++label) {
            const int first = root(label);
            if (open_[static_cast<std::size_t>(first)] != 0) continue;
            numbers[static_cast<std::size_t>(label)] =
                first == label ? ++count : numbers[static_cast<std::size_t>(first)];
        }
        return numbers;
    }

  private:
    int& parent(int label) { return parents_[static_cast<std::size_t>(label)]; }
    std::vector<int> parents_ = {0};  ///< label 0: no cell
    std::vector<char> open_ = {1};
};

}  // namespace

void compute_closed_components(const CellMatrix& matrix, const RowRanges& rows,
                               ClosedComponents& components) {
    const grid::BoxShape& shape = matrix.shape();
    const std::ptrdiff_t to_y = shape.nx, to_z = to_y * shape.ny;
    components.of_cell.assign(static_cast<std::size_t>(to_z * shape.nz), 0);
    Labels labels;
    const auto for_rows = [&](const auto& body) {
        for (int k = 0; k < shape.nz; ++k)
            for (int j = 0; j < shape.ny; ++j) {
                int* row = components.of_cell.data() + j * to_y + k * to_z;
                for (int i = rows.at(j, k).begin; i < rows.at(j, k).end; ++i)
                    body(i, j, k, row + i);
            }
    };
    for_rows([&](int i, int j, int k, int* label) {
        if (!(matrix.diagonal(i, j, k) > 0.0F)) return;
        const auto meet = [&](float coefficient, std::ptrdiff_t step) {
            if (!(coefficient > 0.0F) || label[-step] == *label) return;
            *label = *label == 0 ? label[-step] : labels.join(*label, label[-step]);
        };
        meet(matrix.faces.x.at(i, j, k), 1);
        meet(matrix.faces.y.at(i, j, k), to_y);
        meet(matrix.faces.z.at(i, j, k), to_z);
        if (*label == 0) *label = labels.add();
        if (matrix.boundary.at(i, j, k) + matrix.mass.at(i, j, k) > 0.0F) labels.mark_open(*label);
    });
    components.count = 0;
    const std::vector<int> numbers = labels.numbers(components.count);
    components.sizes.assign(static_cast<std::size_t>(components.count) + 1, 0);
    components.sizes[0] = static_cast<long>(components.of_cell.size());
    for_rows([&](int, int, int, int* label) {
        *label = numbers[static_cast<std::size_t>(*label)];
        --components.sizes[0];
        ++components.sizes[static_cast<std::size_t>(*label)];
    });
}

}  // namespace pastoso::liquid
