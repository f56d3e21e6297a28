# Who may include whom (lib/README.md, "Layers"), read from the #include lines.
load tools/common

# "folder: what it may include besides itself", from the table in lib/README.md. Tools are judged by their link lines.
layers=$(sed -nE 's/^    ([a-z]+) +→ ([a-z]+(, [a-z]+)*)?  .*/\1: \2/p' "$ROOT/lib/README.md" | tr -d ,)

# Own includes of the files under $1: "folder-of-file included-folder file".
own_includes() {
  grep -rHoE '^#include "[a-z]+/' --include='*.?pp' "$ROOT/lib" |
    sed -E "s|^$ROOT/lib/(([a-z]+)/[^:]+):#include \"([a-z]+)/|\2 \3 \1|"
}

@test "every folder of lib is in the table of layers" {
  run -0 comm -3 <(ls -d "$ROOT"/lib/*/ | xargs -n1 basename | sort) <(sed -n 's/:.*//p' <<<"$layers" | sort)
  assert_output ''
}

@test "a folder of lib includes only what its layer may include" {
  run -0 awk '
    NR == FNR { sub(":", ""); for (i = 1; i <= NF; ++i) may[$1, $i] = 1; next }
    !(($1, $2) in may) { print $3 " includes " $2 "/" }' <(echo "$layers") <(own_includes)
  assert_output ''
}

@test "the table has no cycle: each folder includes only folders that do not include it" {
  run -0 awk '
    { sub(":", ""); for (i = 2; i <= NF; ++i) may[$1, $i] = 1 }
    END { for (pair in may) { split(pair, f, SUBSEP); if ((f[2], f[1]) in may) print f[1], f[2] } }' <<<"$layers"
  assert_output ''
}

@test "a folder of lib uses every folder that its layer names" {
  run -0 awk '
    NR == FNR { used[$1, $2] = 1; next }
    { sub(":", ""); for (i = 2; i <= NF; ++i) if (!(($1, $i) in used)) print $1 " does not include " $i "/" }' \
    <(own_includes) <(echo "$layers")
  assert_output ''
}

# Own includes of lib's files, header and source taken as one: "folder/stem included-folder/stem".
stem_includes() {
  (cd "$ROOT/lib" && grep -rHoE '^#include "[a-z0-9_]+/[a-z0-9_]+' --include='*.?pp' .) |
    sed -E 's|^\./([^.]+)\.[ch]pp:#include "(.*)|\1 \2|' | awk '$1 != $2' | sort -u
}

@test "no files include each other in a circle" {
  run -0 tsort <(stem_includes)
}

# "name file" of the types and aliases that headers of lib define at the top level of a namespace.
header_types() {
  grep -rHoE '^(struct|class|enum class|using) [A-Z][A-Za-z0-9]*( final)?( :[^{;]*)? *[{=]' --include='*.hpp' "$ROOT/lib" |
    sed -E "s#^$ROOT/(lib/[^:]+):(struct|class|enum class|using) ([A-Za-z0-9]+).*#\\3 \\1#"
}

@test "no type name is defined in two headers" {
  (($(header_types | wc -l) > 100)) || fail "the types of the headers are not recognised"
  run -0 bash -c 'cut -d" " -f1 | sort | uniq -d' < <(header_types)
  assert_output ''
}

@test "no two folders of lib have files of one name" {
  run -0 bash -c 'find "$0/lib" -name "*.?pp" | sed -E "s|.*/([a-z]+)/([a-z0-9_]+)\..*|\2 \1|" | sort -u | cut -d" " -f1 | uniq -d' \
    "$ROOT"
  assert_output ''
}

@test "each folder of lib is a namespace; base and model are quadrille itself" {
  run -0 bash -c 'cd "$0/lib" && grep -rnE "^namespace quadrille" --include="*.?pp" . |
    sed -E "s|^\./([a-z]+)/[^:]+:[0-9]+:namespace quadrille(::([a-z_]+))?.*|\1 \3|" | sort -u' "$ROOT"
  local expected=
  expected=$(for folder in $(sed 's/:.*//' <<<"$layers" | sort); do
    case $folder in
      base | model) echo "$folder " ;;
      export) echo "$folder exports" ;; # a keyword of the language
      *) echo "$folder $folder" ;;
    esac
  done)
  assert_output "$expected"
}

# only_in FOLDER PATTERN: includes matching PATTERN occur in lib/FOLDER and in no other file.
only_in() {
  local files
  files=$(grep -rlE "^#include [<\"]$2" "$ROOT/lib" "$ROOT/tools" | grep -v "^$ROOT/lib/$1/") || return 0
  fail "$files include what only lib/$1 may include"
}

@test "kernels are included only in the folder that wraps them" {
  only_in occ '[A-Za-z0-9_]+\.hxx'
  only_in triangulate 'CGAL/'
  only_in io '(H5|hdf5)[A-Za-z0-9]*\.h'
  only_in io 'nlohmann/'
  only_in cli 'CLI/'
  only_in quantize 'Cbc'
}

@test "a tool uses no kernel and only libraries of its line in tools/CMakeLists.txt" {
  local tool name uses folder
  for tool in "$ROOT"/tools/*.cpp; do
    name=$(basename "$tool" .cpp)
    uses="$(sed -nE "s/^quadrille_tool\($name(| .*)\)/\1/p" "$ROOT/tools/CMakeLists.txt") check cli io model base "
    for folder in $(sed -nE 's|^#include "([a-z]+)/.*|\1|p' "$tool" | sort -u); do
      linked "$folder" "$uses" || fail "$name.cpp includes $folder/ and is not linked with it"
    done
  done
}

@test "the link lines of lib/CMakeLists.txt are those of the table" {
  run -0 diff <(sed -E 's/: ?/ /; s/ $//' <<<"$layers" | sort) \
    <(sed -nE 's/^quadrille_library\(([a-z]+)( USES ([a-z ]*[a-z]))?( Eigen3::Eigen)?( PRIVATE.*)?\)$/\1 \3/p' \
      "$ROOT/lib/CMakeLists.txt" | sed 's/ $//' | sort)
}

# linked FOLDER "LIBRARIES": FOLDER is one of them or a layer below one of them.
linked() {
  [[ $2 == *" $1 "* ]] && return
  local library
  for library in $2; do
    grep -qE "^$library:.* $1( |$)" <<<"$layers" && return
  done
  return 1
}

# begins HEADER: a source of the same name includes it first, and so compiles it alone.
begins() {
  local source=${1%.hpp}.cpp
  [[ -f $source ]] && grep -m 1 '^#include' "$source" | grep -qF "\"${1#"$ROOT/lib/"}\""
}

@test "no source has more than 350 lines" {
  run -0 bash -c 'find "$1/lib" "$1/tools" \( -name "*.?pp" -o -name "*.js" \) -exec wc -l {} + | awk "\$1 > 350 && \$2 != \"total\""' - "$ROOT"
  assert_output ''
}

@test "every header compiles alone" {
  [[ -n ${QUADRILLE_LONG-} ]] || skip "long: part of tests/run --all"
  local header headers=()
  while read -r header; do begins "$header" || headers+=("$header"); done < <(find "$ROOT/lib" -name "*.hpp" | sort)
  assert [ "${#headers[@]}" -gt 10 ]
  run -0 bash -c 'printf "%s\n" "${@:2}" | xargs -P "$(nproc)" -I{} g++ -std=c++20 -fsyntax-only -w \
    -I"$1/lib" -isystem /usr/include/eigen3 -isystem /usr/include/opencascade -isystem /usr/include/hdf5/serial \
    -x c++ {}' - "$ROOT" "${headers[@]}"
}
