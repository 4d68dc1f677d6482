#!/bin/sh
# Starts Arcomat. JAVA_HOME names the Java to use, where the installation has none of its own; JAVA_OPTS adds options for it.
# ARCOMAT_ARCHIVE names the file of the classes' archive, or is "none".
app=$(readlink -f -- "$0")
app=${app%/bin/*}
if [ -x "$app/java/bin/java" ]; then
    java=$app/java/bin/java
elif ! java=$(command -v "${JAVA_HOME:+$JAVA_HOME/bin/}java"); then
    echo "arcomat: no Java found; install Java 17 or later, or set JAVA_HOME" >&2
    exit 2
fi

# Names of files are UTF-8. Java reads them as the locale says, and as ASCII where there is none, as in
# most containers, or where the one that is named is not installed.
if [ "$(locale charmap 2>/dev/null)" != UTF-8 ]; then
    export LC_ALL=C.UTF-8
fi

# Commands that are over in a moment do not live to see the optimising compiler pay, and see the quick one pay half as
# often as its defaults assume. Those that may be long are over in a moment, too, for most questions: what is compiled three
# times as late saves a question about a small model a quarter of its time, and costs one of millions of pairs nothing.
case ${1-} in
    analyze | campaign | campaign-worker | contradictions | diff | evolution | generate | refines | simulate | test | \
        verify | watch) compiler='-XX:CompileThresholdScaling=3' ;;
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

# Classes are mapped from an archive, which fits one place and one Java: the first start there makes it, so that all others
# take a third less. Beside it stands what it was made for, also where Java could make none.
home=$(readlink -f -- "$java")
home=${home%/bin/java}
version=
{
    while IFS= read -r line; do
        case $line in JAVA_RUNTIME_VERSION=* | JAVA_VERSION=*) version=$version${line#*=} ;; esac
    done <"$home/release"
} 2>/dev/null
purpose="$app, for $home $version"
made_for() {
    [ -r "$archive.for" ] && IFS= read -r made <"$archive.for" && [ "$made" = "$purpose" ]
}
archive=${ARCOMAT_ARCHIVE:-$app/lib/arcomat.jsa}
if [ -z "${ARCOMAT_ARCHIVE-}" ] && [ ! -w "$app/lib" ] && ! made_for; then
    cache=${XDG_CACHE_HOME:-${HOME:+$HOME/.cache}}
    archive=${cache:+$cache/arcomat/@version@.jsa}
    archive=${archive:-none}
fi
make_archive() {
    mkdir -p -- "${archive%/*}" && printf '%s\n' "$purpose" >"$archive.for.$$" || return
    "$java" -Xshare:dump -XX:SharedClassListFile="$app/lib/arcomat.classes" -XX:SharedArchiveFile="$archive.$$" \
        -Xlog:disable -XX:+UseSerialGC -classpath "@classpath@" && mv -f -- "$archive.$$" "$archive"
    mv -f -- "$archive.for.$$" "$archive.for"
}
if [ "$archive" != none ] && ! made_for; then
    [ -n "$watched" ] && echo "arcomat: the first start here takes some seconds more" >&2
    make_archive >/dev/null 2>&1
fi

# Options in JAVA_OPTS may be quoted, as for the start scripts that Gradle writes: xargs takes quotes and backslashes away, and
# sed has the shell take each other letter as it is.
options=
if [ -n "${JAVA_OPTS-}" ]; then
    if ! options=$(printf '%s\n' "$JAVA_OPTS" | xargs -n1 printf '%s\n' 2>/dev/null); then
        echo "arcomat: JAVA_OPTS cannot be read: close each quote, and have xargs on the path" >&2
        exit 2
    fi
    options=$(printf '%s\n' "$options" | sed 's~[^-[:alnum:]+,./:=@_]~\\&~g' | tr '\n' ' ')
fi
set -- -classpath "@classpath@" arcomat.cli.Main "$@"
eval "set -- $options"' "$@"'

# An archive that does not fit is passed over; nobody needs to be told. It is mapped where it was made for: elsewhere,
# every start would write new addresses into all of it. A Java that does not know how need not fail. No option is a date,
# so that their classes need not be loaded.
exec "$java" -Xshare:auto -XX:SharedArchiveFile="$archive" -Xlog:disable \
    -XX:+IgnoreUnrecognizedVMOptions -XX:+UnlockDiagnosticVMOptions -XX:ArchiveRelocationMode=0 \
    -XX:+UseSerialGC $compiler -Dpicocli.converters.excludes='java.(sql|time).*' $watched ${columns:+"-Darcomat.columns=$columns"} "$@"
