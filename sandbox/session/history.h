// Undo and redo: whole Params values, one step between two rests.
#pragma once

#include <optional>
#include <vector>

#include "state/params.h"

namespace viewing {

class History {
public:
    explicit History(Params initial) : current_(std::move(initial)) {}

    /// Called whenever nothing is held or moving: a value that differs from the last rest becomes one step.
    /// Redo is forgotten only then. Returns whether a step was made.
    bool rest(const Params& params);

    std::optional<Params> undo();
    std::optional<Params> redo();
    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }

private:
    static constexpr std::size_t max_steps = 500;
    Params current_;
    std::vector<Params> past_, future_;
};

}  // namespace viewing
