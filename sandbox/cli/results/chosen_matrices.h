// The matrices that `matrices` prints: all, or those of --only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "frame/derive.h"
#include "frame/matrix_symbols.h"

namespace viewing {

struct ChosenMatrix {
    std::string name;  ///< "shadow_from_world", or as it was chosen: "S", "S[2,1]"
    std::string key;   ///< in JSON: "shadow_from_world", "shadow_from_world[2,1]"
    glm::dmat4 matrix{1.0};
    std::optional<MatrixSymbols> symbols = {};  ///< none of PV, nor of one that was entered by hand
    std::optional<double> sign = {};            ///< of S: what is uploaded is sign · S
    std::string sign_name = {}, sign_key = {};  ///< "shadow_sign"
};

/// `only`: a list such as "V,S[2,1],R": C, V, P, PV, S, R; behind S the plane and the light, behind R the plane,
/// counted from 1, left out for the first ones. Left out: these six. Ends the command for a name that there is not.
std::vector<ChosenMatrix> chosen_matrices(const Options& options, const std::optional<std::string>& only,
                                          const Params& params, const Derived& derived);

}  // namespace viewing
