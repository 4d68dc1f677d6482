#!/bin/sh
# The command of the package; the distribution lies where it was put.
exec /usr/share/arcomat/bin/arcomat "$@"
