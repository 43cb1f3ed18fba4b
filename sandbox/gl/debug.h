// GL's own complaints, collected synchronously: any error fails a snapshot and a test.
#pragma once

#include <string>
#include <vector>

namespace viewing::gl {

/// Collects debug output of the current context from construction on. Without KHR_debug, errors() asks glGetError.
/// One per context; it must outlive the context's use.
class DebugLog {
public:
    DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    /// Every error so far, a sentence each.
    const std::vector<std::string>& errors();

    void add(std::string message) { errors_.push_back(std::move(message)); }

private:
    bool has_callback_ = false;
    std::vector<std::string> errors_;
};

}  // namespace viewing::gl
