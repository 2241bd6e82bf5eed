#!/usr/bin/env bash
# Shows the program `offing` in a pipeline: queries a sea at a wave probe, lets awk count waves, and checks the result
# against the certificate that `offing ocean stats` prints.
#
# Build: nothing; offing must be on PATH. Use: probes.sh [SCENE.toml], default: a sea in 10 m/s of wind.
set -euo pipefail

sea=(--size 256)
if (($#)); then sea=("$1"); fi

# Ten minutes at 4 Hz. Waves from one upward crossing of the mean level to the next; height: highest minus lowest value.
measured=$(offing ocean query "${sea[@]}" --at 0,0 --times 0:600:0.25 --quiet | awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  { t[++n] = $column["time_s"]; h[n] = $column["height_m"]; sum += h[n]; sum_of_squares += h[n] * h[n] }
  END {
    mean = sum / n
    for (i = 2; i <= n; ++i) {
      if (h[i - 1] < mean && h[i] >= mean) {
        if (waves++) { heights += high - low; longest = high - low > longest ? high - low : longest } else first = t[i]
        last = t[i]; high = low = h[i]
      }
      if (h[i] > high) high = h[i]
      if (h[i] < low) low = h[i]
    }
    if (waves < 2) { print "error: no waves at the probe" > "/dev/stderr"; exit 1 }
    printf "%.2f %d %.2f %.2f %.2f", 4 * sqrt(sum_of_squares / n - mean * mean), waves - 1,
           (last - first) / (waves - 1), heights / (waves - 1), longest
  }')
read -r hs_m waves period_s mean_height_m highest_m <<<"$measured"
echo "probe: Hs $hs_m m; $waves waves, mean period $period_s s, mean height $mean_height_m m, highest $highest_m m"

# The same sea's certificate, over four seeds: rows of name, unit, asked, ...
offing ocean stats "${sea[@]}" --seeds 4 --quiet | awk -v hs_m="$hs_m" '
  $1 == "Hs" { asked_m = $3 }
  END {
    ratio = hs_m / asked_m
    printf "certificate: Hs %.2f m asked; the probe has %.0f %% of it\n", asked_m, 100 * ratio
    # One probe for ten minutes sees about 100 waves: its Hs scatters by some 7 %.
    exit ratio > 0.7 && ratio < 1.3 ? 0 : 1
  }'
