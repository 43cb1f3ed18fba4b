// Internal to state/: the lines on which all statements of one kind begin. Most statements of a kind are on consecutive
// lines, so each run of such lines is stored as a single entry.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace viewing {

class StatementLines {
public:
    /// Adds the line of the next statement.
    void add(std::uint64_t line) {
        if (runs_.empty() || line != runs_.back().line + (count_ - runs_.back().first)) runs_.push_back({count_, line});
        ++count_;
    }

    /// Returns the line of a statement; `statement` counts from 0.
    std::uint64_t line_of(std::uint64_t statement) const {
        const auto after = std::upper_bound(runs_.begin(), runs_.end(), statement,
                                            [](std::uint64_t number, const Run& run) { return number < run.first; });
        return (after - 1)->line + (statement - (after - 1)->first);
    }

    std::uint64_t count() const { return count_; }

private:
    struct Run {
        std::uint64_t first, line;
    };
    std::vector<Run> runs_;
    std::uint64_t count_ = 0;
};

}  // namespace viewing
