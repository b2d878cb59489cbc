#!/usr/bin/env bash
# One task of the array that paint-again.sh submits: paints one painting of the list. Slurm copies this file, so it uses no
# other. It may be stopped and started again at any moment: a painting takes its place when it is whole.
#
# Usage, under Slurm: paint-again-task.sh PROGRAM LIST RESULTS PX_PER_MM FORMAT
set -euo pipefail

program="$1" list="$2" results="$3" px_per_mm="$4" format="$5"
painting="$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$list")"
result="$results/$(basename -- "$painting" .pastoso).$format"
printf '%s: %s on %s\n' "$(date '+%F %T')" "$painting" "$(uname -n)"
[[ ! -e $result ]] || exit 0
# In the shell's place, so that Slurm's signal to stop reaches the program, which then leaves whole files only.
exec "$program" export "$painting" --again "$px_per_mm" --output "$result" --threads "${SLURM_CPUS_PER_TASK:-0}" --quiet
