# cpack: the .deb and the archive contain all that is installed, and work where they are unpacked.
load ../tools/common

setup_file() {
  [[ -f $BIN/../CPackConfig.cmake ]] || skip "the tools are not in a build folder"
  command -v dpkg-shlibdeps dpkg-deb || skip "no dpkg-shlibdeps: apt-get install dpkg-dev"
  cpack --config "$BIN/../CPackConfig.cmake" -B "$BATS_FILE_TMPDIR/made" >"$BATS_FILE_TMPDIR/log" || return
  tar xzf "$BATS_FILE_TMPDIR"/made/quadrille-*.tar.gz -C "$BATS_FILE_TMPDIR"
  dpkg-deb --extract "$BATS_FILE_TMPDIR"/made/*.deb "$BATS_FILE_TMPDIR/root"
}

setup() {
  common_setup
  deb=$(echo "$BATS_FILE_TMPDIR"/made/*.deb)
  usr=$BATS_FILE_TMPDIR/root/usr
  unpacked=$(echo "$BATS_FILE_TMPDIR"/quadrille-*)
}

@test "the package has dependencies, section, description and maintainer" {
  for field in Section=science Package=quadrille "Architecture=$(dpkg --print-architecture)"; do
    assert_equal "$(dpkg-deb --field "$deb" "${field%=*}")" "${field#*=}"
  done
  run -0 dpkg-deb --field "$deb" Depends
  for library in coinor-libcbc3 parallel python3 libc6 libgmp10 libocct-data-exchange-7.6 libocct-modeling-algorithms-7.6 \
    libnetcdf19; do
    assert_output --regexp "(^|, )$library( |,|\$)"
  done
  run -0 dpkg-deb --field "$deb" Description
  assert_line --index 0 "Curved quadrilateral block meshes from CAD faces"
  assert [ "${#lines[@]}" -gt 3 ]
  run -0 dpkg-deb --field "$deb" Maintainer
  assert_output --regexp '<.*@.*>$'
}

@test "the package contains commands, manual pages, completions, licence, the Python package and the library" {
  for file in bin/quadmesh libexec/cad2tri-step share/man/man1/quadmesh.1 share/man/man7/quadrille.7 \
    share/bash-completion/completions/quadmesh share/zsh/vendor-completions/_quadmesh \
    share/fish/vendor_completions.d/quadmesh.fish share/doc/quadrille/copyright share/doc/quadrille/CITATION.cff \
    "lib/python3/dist-packages/quadrille/field.py" "lib/cmake/Quadrille/QuadrilleConfig.cmake" include/quadrille/files.hpp; do
    assert_file_not_empty "$usr/$file"
    assert_file_not_empty "$unpacked/$file"
  done
  run grep -E '(^|/)__pycache__' <(dpkg-deb --contents "$deb")
  assert_output ''
  assert_equal "$(dpkg-deb --contents "$deb" | awk '$2 != "root/root"')" ''
  run grep -rIl "$ROOT" "$usr"
  assert_output ''
}

@test "the licence names every binary that contains CGAL" {
  cd "$usr"
  for file in bin/* libexec/* lib/*.a; do
    source=$(find "$BIN" "$BIN/../libexec" "$BIN/../lib" -name "${file##*/}") # not stripped
    nm -C "$source" 2>/dev/null | grep -q CGAL:: && echo "$file"
  done | sort >contain || :
  sed -nE 's/^Files: (.usr.*)/\1/p' share/doc/quadrille/copyright | tr " " "\n" | sed "s|^/usr/||" | sort | diff - contain
}

@test "the archive works in any folder: quadmesh runs, man finds its page, completions are read" {
  cp -r "$unpacked" "here and there"
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin "here and there/bin/quadmesh" "$DATA/square.step" -o out.msh
  assert_output --regexp '^1 block, .*'
  MANPATH="$PWD/here and there/share/man" run -0 man -w quadmesh
  bash -c '. "here and there/share/bash-completion/completions/quadmesh"; complete -p quadmesh'
}

@test "the commands of the package are those of the build, stripped" {
  for command in "$usr"/bin/*; do
    [[ $(head -c 2 "$command") == '#!' ]] && continue
    assert_equal "$("$command" --help)" "$("$BIN/${command##*/}" --help)"
    assert [ "$(nm "$command" 2>/dev/null | wc -l)" -eq 0 ]
  done
}

@test "a package that may run on no other machine says so, when it is made and in its description" {
  run -0 cmake -S "$ROOT" -B native -DQUADRILLE_NATIVE=ON -DQUADRILLE_TESTS=OFF
  run -0 grep -F 'CPACK_PACKAGE_DESCRIPTION "' -A 12 native/CPackConfig.cmake
  assert_output --partial "the programs may not run on others"
  run -0 cmake -P "$(sed -n 's/^set(CPACK_PROJECT_CONFIG_FILE "\(.*\)")/\1/p' native/CPackConfig.cmake)"
  assert_output --partial "Built with QUADRILLE_NATIVE, for the processor of one machine"
  assert_equal "$(grep -c "Built with QUADRILLE_NATIVE" "$BIN/../CPackConfig.cmake")" \
    "$(grep -c '^QUADRILLE_NATIVE:BOOL=ON' "$BIN/../CMakeCache.txt")"
}

@test "CITATION.cff has the version and the licence of the project" {
  version=$(sed -nE 's/^project\(quadrille VERSION ([0-9.]+).*/\1/p' "$ROOT/CMakeLists.txt")
  run -0 grep -c -e "^version: $version$" -e '^license: MIT$' -e '^cff-version: 1.2.0$' "$ROOT/CITATION.cff"
  assert_output 3
}

# in_root COMMAND...: runs it in the Debian below $root, which sees its own processes: programs find the ones beside
# them by /proc.
in_root() {
  unshare --mount --pid --fork bash -c 'mount -t proc proc "$0/proc" && exec chroot "$0" env -u TMPDIR "$@"' "$root" "$@"
}

@test "the package installs in a bare Debian 12, quadmesh runs there and man finds its page" {
  [[ -n ${QUADRILLE_LONG-} ]] || skip "long: part of tests/run --all"
  command -v mmdebstrap || skip "no mmdebstrap"
  [[ $(id -u) -eq 0 ]] && unshare --mount true 2>/dev/null || skip "not root, or not allowed to mount"
  root=$BATS_TEST_TMPDIR/debian
  mmdebstrap --mode=root --variant=apt --skip=cleanup/apt bookworm "$root" >log 2>&1 || skip "mmdebstrap: $(tail -1 log)"
  cp "$deb" "$root/quadrille.deb"
  cp "$DATA/half_disc.step" "$root"
  run -0 in_root env DEBIAN_FRONTEND=noninteractive apt-get -y --no-install-recommends install /quadrille.deb \
    man-db python3-h5py
  run -0 in_root quadmesh /half_disc.step -o /half_disc.msh --workdir /stages
  assert_output --regexp '^4 blocks, .*'
  run -0 in_root man -w quadmesh quadrille
  run -0 in_root python3 -c 'import quadrille; print(quadrille.read("/stages/half_disc.crit.json").valences)'
  assert_output '[3 3]'
}
