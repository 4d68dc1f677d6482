#!/bin/bash
# What somebody does at Kate, on a screen that nobody sees: a misspelled model is opened, mended, laid out, and its port renamed.
# What came of it is in the files, which Kate saves. In the folder of the models; the arguments are a file to be opened, and
# where what the server says is written by whoever starts it.
set -u
door=$1
said=$2

# Tries again until it is to be seen, for a minute.
await() {
    for _ in $(seq 60); do
        if "$@"; then return; fi
        sleep 1
    done
    echo "waited in vain for: $*"
    exit 1
}

keys() {
    xdotool key --delay 100 "$@"
    sleep 1
}

number=$(mktemp)
Xvfb -screen 0 1024x768x24 -displayfd 3 3>"$number" &
screen=$!
await test -s "$number"
export DISPLAY=:$(cat "$number")
rm "$number"
kate -n -l 11 -c 20 "$door" &
editor=$!
# Until the server, which holds the lock, is gone as well.
leave() {
    kill $editor
    wait $editor
    flock -w 60 "$said.lock" true
    kill $screen
    wait $screen
}
trap 'leave 2>/dev/null' EXIT

found() { grep -q '"code":"ARC0305"' "$said"; }
await found

window() { xdotool search --onlyvisible --name "$1" >/dev/null; }
await window Door.arc

# Nobody else does where there is no window manager.
focus() {
    xdotool windowfocus "$(xdotool search --onlyvisible --name Door.arc | tail -1)"
    sleep 1
}
focus

mend() {
    keys ctrl+period ctrl+s
    grep -q '{pressed == true}' "$door"
}
await mend

lay_out() {
    keys ctrl+t f
    keys ctrl+s
    grep -q '^        state closed;' "$door"
}
await lay_out

rename() {
    keys F2
    window '^Rename' || return
    keys ctrl+a
    xdotool type pushed
    keys Return
    focus
    keys ctrl+s
    grep -q '{pushed == true}' "$door"
}
await rename

# The other file was opened to be changed.
save_other() {
    keys ctrl+Next ctrl+s
    grep -q front.pushed "$(dirname "$door")/House.arc"
}
await save_other
