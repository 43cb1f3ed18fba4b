// libFuzzer: reads arbitrary text as a suite. An accepted suite must have entries whose files have distinct names.
#include <set>

#include "fuzz.h"
#include "suite/suite.h"

using namespace viewing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::MemoryFile file(fuzz::as_text(data, size));
    const Result<Suite> suite = load_suite(file.path().string());
    if (!suite) {
        fuzz::check_message(suite.error());
        return 0;
    }
    fuzz::check(!suite->entries.empty());
    std::set<std::string> names;
    for (const SuiteEntry& entry : suite->entries) {
        fuzz::check(names.insert(entry.file_name).second);
        fuzz::check(!entry.file_name.empty() && entry.file_name.find('/') == std::string::npos);
        fuzz::check(entry.size_px.x > 0 && entry.size_px.y > 0);
    }
    return 0;
}
