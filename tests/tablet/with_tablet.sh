#!/usr/bin/env bash
# Runs a program on an X server of its own that has a pen with two ends. The program finds the pipes of
# both (pen_lines.h) in the folder $PASTOSO_TEST_TABLET, as "pen" and "eraser".
#
# Usage: with_tablet.sh MODULES PROGRAM [ARGUMENT...]
#   MODULES   the folder that has input/tablet_drv.so
set -euo pipefail

modules="$1"
shift
PASTOSO_TEST_TABLET="$(mktemp -d)"
export PASTOSO_TEST_TABLET
sed -e "s#@MODULES@#$modules#" -e "s#@FOLDER@#$PASTOSO_TEST_TABLET#" \
    "$(dirname -- "${BASH_SOURCE[0]}")/xorg.conf.in" >"$PASTOSO_TEST_TABLET/xorg.conf"
Xorg -displayfd 3 -config "$PASTOSO_TEST_TABLET/xorg.conf" -logfile "$PASTOSO_TEST_TABLET/log" \
    -noreset -novtswitch -sharevts -nolisten tcp 3>"$PASTOSO_TEST_TABLET/number" 2>"$PASTOSO_TEST_TABLET/errors" &
server=$!
stop_server() {
    kill "$server" 2>/dev/null || true
    wait "$server" 2>/dev/null || true
    rm -rf "$PASTOSO_TEST_TABLET"
}
trap stop_server EXIT
for ((waited = 0; waited < 300; ++waited)); do
    [[ -s $PASTOSO_TEST_TABLET/number ]] && break
    kill -0 "$server" 2>/dev/null || break
    sleep 0.1
done
[[ -s $PASTOSO_TEST_TABLET/number ]] || {
    cat "$PASTOSO_TEST_TABLET/errors" >&2
    echo "with_tablet.sh: the X server did not start." >&2
    exit 1
}
DISPLAY=":$(tr -d '[:space:]' <"$PASTOSO_TEST_TABLET/number")"
export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
unset WAYLAND_DISPLAY
"$@"
