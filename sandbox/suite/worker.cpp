#include "suite/worker.h"

#include <string>

#include "gl/facts.h"

namespace viewing {
namespace {

void answer(std::FILE* output, const Json& json) {
    // A result may quote invalid UTF-8 from its input, so replace such bytes.
    const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    std::fwrite(line.data(), 1, line.size(), output);
    std::fflush(output);
}

}  // namespace

void serve_entries(const Suite& suite, CheckWish wish, Renderer& renderer, gl::DebugLog& log, std::istream& input,
                   std::FILE* output) {
    const gl::ContextFacts facts = gl::context_facts();
    wish.program += "\n" + facts.renderer + "\n" + facts.version;
    answer(output, {{"renderer", facts.renderer}});
    for (std::string line; std::getline(input, line);) {
        const Json told = Json::parse(line);
        const SuiteEntry& entry = suite.entries.at(told.at("entry").get<std::size_t>());
        wish.known_key = told.at("key").get<std::string>();
        answer(output, as_json(check_entry(suite, entry, wish, renderer, log)));
    }
}

}  // namespace viewing
