#!/usr/bin/env bash
# Brings the files of the translators, resources/translations/*.ts, up to date with the words in the code: new ones
# stand there as unfinished, and what was translated stays.
#
# Usage: packaging/words.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    "") ;;
    *) refuse_argument "$1" ;;
esac

lupdate="$(qmake6 -query QT_INSTALL_BINS 2>/dev/null)/lupdate"
[[ -x "$lupdate" ]] || fail "there is no lupdate; packaging/install.sh build installs it."
cd "$root"
for language in en ja sv zh_TW; do
    "$lupdate" -silent -locations none -no-obsolete -tr-function-alias QT_TR_NOOP+=PASTOSO_WORDS -tr-function-alias QT_TR_NOOP+=step_name app engine/document/actions -ts "resources/translations/pastoso_$language.ts" \
        -source-language en -target-language "$language" 2>&1 |
        sed '/lacks Q_OBJECT macro/d; /Qualifying with unknown/d'  # of tables that are translated by their namespace
done
