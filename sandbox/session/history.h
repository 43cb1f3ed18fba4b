// Undo and redo of whole values: all changes between two pauses make one step.
#pragma once

#include <deque>
#include <optional>
#include <utility>

namespace viewing {

template <typename Value>
class History {
public:
    explicit History(Value initial) : current_(std::move(initial)) {}

    /// Called whenever nothing is held or moving: a value that differs from that of the previous call becomes one step.
    /// Only such a step drops the redo steps. Returns whether a step was made.
    bool rest(const Value& value) {
        if (value == current_) return false;
        if (past_.size() == max_steps) past_.pop_front();
        past_.push_back(std::exchange(current_, value));
        future_.clear();
        return true;
    }

    std::optional<Value> undo() { return step(past_, future_); }
    std::optional<Value> redo() { return step(future_, past_); }
    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }

private:
    static constexpr std::size_t max_steps = 500;

    std::optional<Value> step(std::deque<Value>& from, std::deque<Value>& to) {
        if (from.empty()) return std::nullopt;
        to.push_back(std::exchange(current_, std::move(from.back())));
        from.pop_back();
        return current_;
    }

    Value current_;
    std::deque<Value> past_, future_;  ///< deques drop their oldest step cheaply
};

}  // namespace viewing
