// GL's error messages, collected synchronously: any error makes a snapshot or a test fail.
#pragma once

#include <string>
#include <vector>

namespace viewing::gl {

/// Collects the debug output of the current context from construction on. Without KHR_debug, errors() calls
/// glGetError(). Make one per context; it must live as long as the context is used.
class DebugLog {
public:
    DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    /// Returns all errors so far, one sentence each.
    const std::vector<std::string>& errors();

    void add(std::string message) { errors_.push_back(std::move(message)); }

private:
    bool has_callback_ = false;
    std::vector<std::string> errors_;
};

}  // namespace viewing::gl
