#!/usr/bin/env bash
# Runs a suite in shards with GNU parallel (Debian: parallel), on this machine or on several that share its folder:
#     sandbox/packaging/parallel.sh SUITE [SHARDS [LOGINS]]
# SHARDS: default one per core. LOGINS: for parallel's --sshlogin, "8/render1,8/render2"; the program must then be on
# each machine's PATH. VIEWING_SANDBOX is the program's path on this machine. Exits with the status of the merged run.
set -euo pipefail
suite=${1:?which suite? parallel.sh SUITE [SHARDS [LOGINS]]}
shards=${2:-$(nproc)}
program=${VIEWING_SANDBOX:-viewing-sandbox}
folder=$(dirname "$suite")
earlier=()
[[ -e $folder/report/report.json ]] && earlier=(--times "$folder/report")

hosts=()
[[ -n ${3:-} ]] && hosts=(--sshlogin "$3" --workdir "$PWD")
# A shard with differences exits with status 1. Continue, since the merged report shows them.
parallel --will-cite --jobs "$shards" "${hosts[@]}" --tag \
    "$program" suite run "$suite" --shard "{}/$shards" "${earlier[@]}" '|| test $? = 1' ::: $(seq "$shards")
reports=()
for shard in $(seq "$shards"); do
    report=$folder/report-$shard-of-$shards
    [[ -e $report/report.json ]] && reports+=("$report")
done
exec "$program" suite merge "$suite" "${reports[@]}"
