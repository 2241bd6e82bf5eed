#!/bin/sh
# build_and_run.sh COMPILER PKG_CONFIG_FOLDER SOURCE PROGRAM: compiles SOURCE with the flags of `pkg-config offing`.
set -eu
flags=$(PKG_CONFIG_PATH="$2${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}" pkg-config --cflags --libs offing)
# pkg-config quotes its output for a shell; eval undoes that, so that a prefix may hold spaces.
eval "set -- \"\$@\" $flags"
compiler=$1 source=$3 program=$4
shift 4
"$compiler" -std=c++20 "$source" -o "$program" "$@"
"$program"
