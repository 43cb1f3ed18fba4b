// Writes the man page and the completions for bash and zsh, which a package contains in addition to the program and its
// assets. Runs during the build and uses the same table as --help. Usage: generate FOLDER.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "packaging/pages.h"
#include "platform/file.h"

int main(int argc, char** argv) {
    using namespace viewing;
    if (argc != 2) {
        std::fprintf(stderr, "usage: generate FOLDER\n");
        return EXIT_FAILURE;
    }
    const std::filesystem::path folder = argv[1];
    for (const auto& [name, text] :
         {std::pair{"viewing-sandbox.1", man_page()}, std::pair{"viewing-sandbox.bash", bash_completion()},
          std::pair{"_viewing-sandbox", zsh_completion()}})
        if (const Status written = write_file(folder / name, std::string_view(text)); !written) {
            std::fprintf(stderr, "%s\n", written.error().c_str());
            return EXIT_FAILURE;
        }
    return EXIT_SUCCESS;
}
