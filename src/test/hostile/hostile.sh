#!/bin/sh
# A bot that attacks as its first argument says, when it is asked for the second time. The second argument marks the
# processes of the match, and nothing here reaches for any other; the third is the PID namespace of the referee. What
# survives its attack plays on, badly.
attack=$1
mark=$2
outside=$3
answer='{"pods":[{"x":8000,"y":4500,"thrust":50}]}'
big=$(printf '%065536d' 0)

say() { printf '%s\n' "$answer"; }

# A process that stays, known by the mark.
stay() { exec sh -c 'while :; do sleep 0.1; done' stay "$mark"; }

# The numbers of marked processes whose command line has a word; not its own, nor that of the first process, which names
# the files of all bots that it keeps this one from writing to.
marked() {
  for line in $(grep -lsa "$mark" /proc/[0-9]*/cmdline); do
    pid=${line#/proc/}
    [ "${pid%/*}" != $$ ] && [ "${pid%/*}" != 1 ] && grep -qsa "$1" "$line" && echo "${pid%/*}"
  done
}
referee() { marked steward.cli.Main; }
sentinel() {
  for referee in $(referee); do
    for line in $(grep -lsa steward-sentinel /proc/[0-9]*/cmdline); do
      pid=${line#/proc/}
      grep -qs "^PPid:.$referee\$" "${line%cmdline}status" && echo "${pid%/*}"
    done
  done
}
opponent() { marked 'honest.sh'; }
send() { signal=$1; shift; for pid in "$@"; do kill -s "$signal" "$pid"; done; }

if [ "$attack" = early ]; then
  for k in 1 2 3 4 5; do say; done
fi
[ "$attack" = silent-start ] && stay
read -r setup
read -r turn
say
read -r turn
exec 7>&2 2>/dev/null
case $attack in
  early) ;;
  exit-0) exit 0 ;;
  exit-3) exit 3 ;;
  exit-255) exit 255 ;;
  signal-*) kill -s "${attack#signal-}" $$ ;;
  kill-group) kill -s KILL 0 ;;
  stop) kill -s STOP $$ ;;
  loop) while :; do :; done ;;
  half) printf '{"pods":'; stay ;;
  doubled) say; say ;;
  flooded) k=0; while [ $k -lt 5000 ]; do say; k=$((k + 1)); done ;;
  long-line) while printf %s "$big"; do :; done ;;
  nul) printf '\0\0\0\n' ;;
  bad-utf8) printf '{"pods":[{"x":1,"y":2,"thrust":"\377\376\300\200"}]}\n' ;;
  deep) printf '%030000d\n' 0 | tr 0 '[' ;;
  duplicate) echo '{"pods":[{"x":1,"x":2,"y":2,"thrust":50}]}' ;;
  huge-number) echo '{"pods":[{"x":1e999,"y":2,"thrust":50}]}' ;;
  thrust) echo '{"pods":[{"x":1,"y":2,"thrust":2147483648}]}' ;;
  nan) echo '{"pods":[{"x":NaN,"y":2,"thrust":50}]}' ;;
  empty) echo ;;
  stderr-flood) yes "$big" | head -c 50000000 >/dev/fd/7 ;;
  no-stdin) exec <&-; say; stay ;;
  no-stdout) exec >&- 7>&-; stay ;;
  children) k=0; while [ $k -lt 20 ]; do (stay) & k=$((k + 1)); done ;;
  children-exit) (stay) & exit 5 ;;
  deaf-children) trap '' HUP INT TERM; (stay) & ;;
  leaves) (setsid sh -c '(while :; do sleep 0.1; done) &' stay "$mark" </dev/null >/dev/null 7>&-) ;;
  holds-stdout) (setsid sh -c '(while :; do sleep 0.1; done) &' stay "$mark" </dev/null 7>&-); exit 6 ;;
  fills-stderr) (setsid sh -c '(while :; do echo more; sleep 0.01; done) &' stay "$mark" </dev/null >/dev/fd/7 7>&-) ;;
  kills-referee) send KILL $(referee) ;;
  stops-referee) send STOP $(referee); sleep 0.2; send CONT $(referee) ;;
  terminates-referee) send TERM $(referee) ;;
  kills-sentinel) send KILL $(sentinel) ;;
  kills-both) send KILL $(sentinel) $(referee); [ "$(readlink /proc/self/ns/pid)" = "$outside" ] && stay ;;
  kills-opponent) send KILL $(opponent) ;;
  stops-opponent) send STOP $(opponent) ;;
  reads-opponent)
    for pid in $(opponent); do cat "/proc/$pid/environ" >/dev/null && [ -e "/proc/$pid/fd/0" ] && exit 77; done ;;
  forges) for pid in $(opponent); do echo forged >"/proc/$pid/fd/1"; done ;;
  changes-replay)
    for pid in $(referee); do
      for file in "/proc/$pid/fd/"*; do
        case $(readlink "$file") in *"$mark"*.jsonl) echo forged >>"$file" && exit 77 ;; esac
      done
    done ;;
  unmounts)
    if [ "$(readlink /proc/self/ns/pid)" != "$outside" ]; then           # never the machine's own
      umount /proc; umount -l /proc
      unshare -Urm sh -c 'umount /proc; umount -l /proc'
      for pid in $(referee) $(opponent); do exit 77; done
    fi ;;
  fills-disk) head -c 80000000 /dev/zero >"${TMPDIR:-/tmp}/$mark.fill"; rm -f "${TMPDIR:-/tmp}/$mark.fill" ;;
  hogs) for k in 1 2 3 4; do sh -c 'while :; do :; done' hog "$mark" & done ;;
  *) exit 99 ;;
esac
case $attack in signal-* | stop | kill-group | nul | empty | deep | long-line) ;; *) say ;; esac
while read -r turn; do say; done
