#include "topics/depth/measured/fighting_as_json.h"

#include "report/as_json.h"
#include "text/per_enum.h"
#include "topics/depth/measured/fighting_measure.h"
#include "topics/depth/measured/minimum_gap.h"

namespace viewing {
namespace {

/// Returns the parts of a predicted gap; `slant` converts them from a difference in eye distance to a length along the
/// surface's normal. The total is null if no gap is wide enough.
Json onset_as_json(const FightingOnset& onset, double slant) {
    return {{"quantisation", onset.quantization * slant},
            {"arithmetic", onset.arithmetic * slant},
            {"predicted_onset_gap", onset.is_reachable ? Json(onset.gap() * slant) : Json()}};
}

Json share_as_json(const ShareInterval& share) {
    return {{"least", share.least}, {"most", share.most}};
}

Json spread_as_json(const ShareSpread& spread) {
    if (spread.cameras == 0) return nullptr;
    return {{"cameras", spread.cameras},
            {"mean", spread.mean()},
            {"standard_error", spread.standard_error()},
            {"least", spread.least},
            {"most", spread.most}};
}

Json pair_as_json(const CountedPair& counted, const FightingReport::Row& row) {
    const PairPrediction& predicted = row.predicted;
    Json json{{"objects", {row.first, row.second}},
              {"distance", predicted.distance},
              {"gap", counted.pair.gap()},
              {"step", predicted.step},
              {"wrong", counted.wrong},
              {"vanished", counted.vanished},
              {"pixels", counted.pixels},
              {"predicted_wrong_fraction", predicted.wrong_share ? share_as_json(*predicted.wrong_share) : Json()},
              {"trembling_wrong_fraction", spread_as_json(row.spread)}};
    json.update(onset_as_json(predicted.onset, predicted.slant));
    return json;
}

Json counts_as_json(const FightingCounts& counts) {
    return {{"wrong_fraction", counts.wrong_fraction()},
            {"elsewhere",
             {{"wrong", counts.wrong_elsewhere},
              {"bleeding", counts.bleeding_elsewhere},
              {"vanished", counts.vanished_elsewhere},
              {"pixels", counts.pixels_elsewhere}}}};
}

/// In the order of CureKind.
constexpr auto cure_names =
    per_enum<CureKind>("near", "float", "reversed_float", "logarithmic", "offset", "equal", "stencil");

Json cures_as_json(const std::vector<FightingReport::Cured>& cured) {
    Json cures = Json::array();
    for (const auto& [cure, counts] : cured) {
        Json json{{"name", cure_names[cure.kind]}};
        json.update(counts ? counts_as_json(*counts) : Json());
        cures.push_back(std::move(json));
    }
    return cures;
}

Json search_as_json(const MinimumGap& found) {
    Json search{{"distance", found.distance},
                {"pictures", found.pictures},
                {"problem", found.problem.empty() ? Json() : Json(found.problem)}};
    search.update(onset_as_json(found.predicted, 1.0));
    return search;
}

}  // namespace

Result<Json> fighting_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px,
                              bool counts_alone) {
    return guarded([&] {
        const Derived derived = derive(params, scene, renderer.viewport(size_px, params.depth.format));
        FightingReport report =
            fighting_report(or_refuse(count_fighting(renderer, params, scene, near_coplanar_pairs(scene), size_px)),
                            params, derived, scene, size_px);
        if (!counts_alone) {
            or_refuse(count_cures(report, renderer, scene));
            or_refuse(count_spread(report, renderer, params, scene));
        }
        Json pairs = Json::array();
        for (std::size_t i = 0; i < report.rows.size(); ++i)
            pairs.push_back(pair_as_json(report.counts.pairs[i], report.rows[i]));
        Json json{{"scene", scene_name(params)}, {"size", as_json(size_px)}, {"pairs", std::move(pairs)}};
        json.update(counts_as_json(report.counts));
        if (counts_alone) return json;
        const MinimumGap found = or_refuse(find_minimum_gap(renderer, params, derived.facts.target_distance));
        json.update({{"cures", cures_as_json(report.cured)},
                     {"minimum_gap", found.gap ? Json(*found.gap) : Json()},
                     {"search", search_as_json(found)}});
        return json;
    });
}

}  // namespace viewing
