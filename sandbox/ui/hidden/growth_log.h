// The rows of a measurement on their way from its thread to the window.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "visibility/growth.h"

namespace viewing {

/// Safe to use from both threads.
class GrowthLog {
public:
    void add(GrowthRow row) {
        const std::lock_guard lock(mutex_);
        rows_.push_back(std::move(row));
    }
    std::vector<GrowthRow> rows() const {
        const std::lock_guard lock(mutex_);
        return rows_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<GrowthRow> rows_;
};

}  // namespace viewing
