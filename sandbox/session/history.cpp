#include "session/history.h"

#include <utility>

namespace viewing {

bool History::rest(const Params& params) {
    if (params == current_) {
        return false;
    }
    if (past_.size() == max_steps) {
        past_.erase(past_.begin());
    }
    past_.push_back(std::exchange(current_, params));
    future_.clear();
    return true;
}

std::optional<Params> History::undo() {
    if (past_.empty()) {
        return std::nullopt;
    }
    future_.push_back(std::exchange(current_, std::move(past_.back())));
    past_.pop_back();
    return current_;
}

std::optional<Params> History::redo() {
    if (future_.empty()) {
        return std::nullopt;
    }
    past_.push_back(std::exchange(current_, std::move(future_.back())));
    future_.pop_back();
    return current_;
}

}  // namespace viewing
