# What the scripts that submit arrays of tasks share: sourced, not run. They set `program`,
# `scheduling`, `dry_run` and `tasks`, and `too_long` where an array can be made shorter.
# shellcheck shell=bash

# whole_number OPTION TEXT: from 1 to a million.
whole_number() {
    [[ $2 =~ ^([1-9][0-9]{0,5}|1000000)$ ]] || fail "$1: \"$2\" is not a whole number from 1 to 1000000."
}

find_program() {
    [[ -n $program ]] || program="$(type -P pastoso-cli || true)"
    [[ -n $program ]] || program="$root/build/release/bin/pastoso-cli"
    [[ -f $program && -x $program ]] ||
        fail "there is no pastoso-cli at \"$program\"; --program FILE says where it is, packaging/build.sh builds it."
    program="$(realpath -- "$program")"
}

check_sbatch() {
    type -P sbatch >/dev/null || fail "there is no sbatch on the PATH; run this where jobs are submitted from (Debian: slurm-client)."
}

# submit_tasks NAME CPUS RESULTS SCRIPT ARGUMENT...: the array, whose number becomes `job`. What tasks say goes to
# RESULTS/slurm.
submit_tasks() {
    local name="$1" cpus="$2" results="$3"
    shift 3
    local command=(sbatch --parsable "--array=$tasks" "--job-name=$name" --requeue --open-mode=append
        "--cpus-per-task=$cpus" "--output=$results/slurm/%A_%a.log" "${scheduling[@]}" "$@")
    if [[ $dry_run == yes ]]; then
        printf '%q ' "${command[@]}"
        printf '\n'
        exit 0
    fi
    mkdir -p -- "$results/slurm" || fail "\"$results\" cannot be made."
    job="$("${command[@]}")" ||
        fail "sbatch did not take the array; its message stands above.${too_long:+ $too_long}"
    job="${job%%;*}"  # "JOB;CLUSTER" where there are several
}

# tell_job RESULTS WHAT_STAYS
tell_job() {
    cat <<TEXT
   follow   squeue --jobs=$job; what a task says goes to $1/slurm/${job}_TASK.log
   stop     scancel $job
   resume   the same command again: what is $2 stays, only the rest is submitted
TEXT
}
