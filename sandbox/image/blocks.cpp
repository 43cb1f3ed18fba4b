#include "image/blocks.h"

#include <algorithm>

namespace viewing {

std::size_t BlockFinder::root_of(std::size_t block) {
    while (parents_[block] != block) block = parents_[block] = parents_[parents_[block]];
    return block;
}

void BlockFinder::add_row(int y, std::span<const std::uint8_t> difference, int worst) {
    if (y != y_ + 1) above_.clear();
    y_ = y;
    std::vector<Run> runs;
    const int width = static_cast<int>(difference.size());
    std::size_t first_above = 0;
    for (int x = 0; x < width; ++x) {
        if (difference[x] <= worst) continue;
        Run run{x, x + 1, parents_.size()};
        while (run.end < width && difference[run.end] > worst) ++run.end;
        parents_.push_back(run.block);
        pixels_.push_back(run.end - run.begin);
        while (first_above < above_.size() && above_[first_above].end < run.begin) ++first_above;
        for (std::size_t i = first_above; i < above_.size() && above_[i].begin <= run.end; ++i) {
            const std::size_t above = root_of(above_[i].block);
            if (above == run.block) continue;
            pixels_[above] += pixels_[run.block];
            parents_[run.block] = above;
            run.block = above;
        }
        runs.push_back(run);
        x = run.end;
    }
    above_ = std::move(runs);
}

std::int64_t BlockFinder::blocks() const {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < parents_.size(); ++i) count += parents_[i] == i;
    return count;
}

std::int64_t BlockFinder::largest() const {
    std::int64_t most = 0;
    for (std::size_t i = 0; i < parents_.size(); ++i)
        if (parents_[i] == i) most = std::max(most, pixels_[i]);
    return most;
}

}  // namespace viewing
