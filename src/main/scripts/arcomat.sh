#!/bin/sh
# Starts Arcomat. JAVA_HOME names the Java to use, JAVA_OPTS adds options for it.
app=$(CDPATH= cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
java=${JAVA_HOME:+$JAVA_HOME/bin/}java
if ! command -v "$java" >/dev/null 2>&1; then
    echo "arcomat: no Java found; install Java 17 or later, or set JAVA_HOME" >&2
    exit 2
fi

# Names of files are UTF-8. Java reads them as the locale says, and as ASCII where there is none, as in
# most containers, or where the one that is named is not installed.
if [ "$(locale charmap 2>/dev/null)" != UTF-8 ]; then
    export LC_ALL=C.UTF-8
fi

# Commands that are over in a moment do not live to see the optimising compiler pay, and see the quick one pay half as
# often as its defaults assume.
case ${1-} in
    analyze | campaign | campaign-worker | contradictions | diff | evolution | generate | language-server | refines | \
        simulate | test | verify | watch) compiler= ;;
    *) compiler='-XX:TieredStopAtLevel=1 -XX:CompileThresholdScaling=2' ;;
esac

# Whether somebody looks on, and how wide a line may be. Java cannot find out. COLUMNS has the last word, also
# where there is no terminal.
watched=
[ -t 2 ] && watched=-Darcomat.watched=true
columns=${COLUMNS-}
if [ -z "$columns" ] && [ -t 1 ]; then
    { columns=$(stty size <&3 2>/dev/null); } 3>&1 # what is captured is no terminal
    columns=${columns#* }
    [ "${columns:-0}" -gt 0 ] 2>/dev/null || columns=80
fi

# Classes are mapped from an archive that was made with the installation. Another Java, or an
# installation that was moved, starts without it, a little later; nobody needs to be told.
exec "$java" -Xshare:auto -XX:SharedArchiveFile="$app/lib/arcomat.jsa" -Xlog:disable \
    -XX:+UseSerialGC $compiler $watched ${columns:+"-Darcomat.columns=$columns"} $JAVA_OPTS -classpath "@classpath@" arcomat.cli.Main "$@"
