# pipelines/quadgallery: the examples of the paper, with its numbers beside ours.
load ../tools/common

quadgallery=$ROOT/pipelines/quadgallery

@test "each example has its pictures; nodes are those of the paper where it states them; nothing else is left" {
  run -0 --separate-stderr env TMPDIR="$PWD" "$quadgallery" --to out
  assert_output --regexp '^7 examples in [0-9.]+ CPU seconds: out/gallery.html$'
  assert_equal "$stderr" ""
  assert_equal "$(ls)" out
  assert_equal "$(find out -type f | wc -l)" 22
  run -0 grep -oE 'src="[^"]*"' out/gallery.html
  assert_equal "${#lines[@]}" 21
  while read -r picture; do xmllint --noout "out/$picture"; done < <(printf '%s\n' "${lines[@]}" | cut -d '"' -f 2)
  run -0 sed -nE 's|^<tr><td>irregular nodes</td><td>(.*)</td><td>(.*)</td></tr>$|\1: \2|p' out/gallery.html
  assert_output "2 of valence 3: 2 of valence 3
2 of valence 3: 2 of valence 3
2 of valence 3: 2 of valence 3
4 of valence 3: 4 of valence 3
1 of valence 3, 1 of valence 5: not stated
none: not stated
2 of valence 5: not stated"
  xmllint --html --noout out/gallery.html
  "$quadgallery" -q --to again
  diff -r out again
}

@test "the commands of the page give the numbers of the page" {
  "$quadgallery" -q --to out
  cp "$DATA"/{half_disc,geometry_?}.step .
  sed -nE 's|^<pre>(.*)</pre>$|\1 --report -|p' out/gallery.html >commands
  assert_equal "$(wc -l <commands)" 7
  sed -nE 's|^<tr><td>blocks.*</td><td>([0-9]+)</td><td>.*|\1|p' out/gallery.html >blocks
  PATH=$ROOT/pipelines:$PATH bash -euo pipefail commands 2>/dev/null | jq .blocks | diff blocks -
}

@test "mistakes on the command line are exit 2 with a hint; the help's example works" {
  for arguments in "" "--to" "x --to y" "--frob"; do
    # shellcheck disable=SC2086
    run -2 --separate-stderr "$quadgallery" $arguments
    assert_equal "${stderr_lines[1]}" "try 'quadgallery --help'"
  done
  run -4 "$quadgallery" --to /dev/null/out
  read -r _ arguments < <("$quadgallery" --help | sed '1,/^EXAMPLES$/d')
  # shellcheck disable=SC2086
  run -0 "$quadgallery" $arguments -v
  assert_line --regexp '^Half disc: 4 blocks, irregular nodes: 2 of valence 3, [0-9.]+ s$'
}
