#!/usr/bin/env bash
# In the place of Slurm's sbatch, for render_farm_test.cpp: runs the tasks of an array one after the other. As Slurm
# does, it copies the script away and tells each task its number. Tasks named in the file "broken" beside it do not run, as
# on a machine that is switched off.
here="$(dirname -- "$0")"
while [[ $1 == --* ]]; do
    [[ $1 != --array=* ]] || list="${1#--array=}"
    printf '%s\n' "$1" >>"$here/options"
    shift
done
cp -- "$1" "$here/spooled"
shift
for part in ${list//,/ }; do
    for task in $(seq "${part%-*}" "${part#*-}"); do
        grep -qx "$task" "$here/broken" 2>/dev/null && continue
        SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_PER_TASK=1 bash "$here/spooled" "$@" >>"$here/log" 2>&1
    done
done
echo "77;cluster"
