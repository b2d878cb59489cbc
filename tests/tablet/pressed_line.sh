#!/usr/bin/env bash
# Draws a line in Pastoso's window by the pen of with_tablet.sh, or of with_wayland.sh --tablet, pressing harder all the way,
# until the journal of the painting (docs/journal-format.md) holds every pressure that was told.
#
# Usage: pressed_line.sh PASTOSO
set -euo pipefail

[[ -p $PASTOSO_TEST_TABLET/pen ]] || {
    echo "pressed_line.sh: there is no pen in $PASTOSO_TEST_TABLET." >&2
    exit 1
}
home="$(mktemp -d)"
XDG_STATE_HOME="$home" XDG_CONFIG_HOME="$home" XDG_DATA_HOME="$home" XDG_CACHE_HOME="$home" \
    "$1" --profile >"$home/log" 2>&1 &  # without a start page
program=$!
stop_program() {
    kill -KILL "$program" 2>/dev/null || true
    wait "$program" 2>/dev/null || true
    rm -rf -- "$home"
}
trap stop_program EXIT

told="$(seq 10 2 90)"  # hundredths

draw_line() {
    local x=500 pressure
    {
        printf 'near 1\nmove %d 450 0 0 0\ntip 1\n' $x
        for pressure in $told; do
            printf 'move %d 450 0.%d 0 0\n' $((x += 5)) "$pressure"
        done
        printf 'tip 0\nnear 0\n'
    } >"$PASTOSO_TEST_TABLET/pen"
}

# A sample is [time, x, y, pressure, ...].
kept() {
    find "$home" -name strokes.journal -exec grep -aohE '"samples":\[(\[[^]]*\],?)*\]' {} + | grep -o '\[[0-9][^][]*\]' |
        awk -F, '{ printf "%.0f\n", 100 * $4 }' | sort -u
}

# What is drawn before the window is on the screen is not heard.
for ((line = 0; line < 120; ++line)); do
    kill -0 "$program" 2>/dev/null || break
    draw_line
    sleep 1
    [[ -z $(comm -23 <(sort <<<"$told") <(kept)) ]] || continue
    echo "All $(wc -l <<<"$told") pressures of the pen are in the painting."
    exit 0
done
cat "$home/log" >&2
echo "pressed_line.sh: of the pressures $(tr '\n' ' ' <<<"$told")the painting holds $(kept | tr '\n' ' ')" >&2
exit 1
