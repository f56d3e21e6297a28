# Who may include whom (lib/README.md, "Layers"), read from the #include lines.
load tools/common

# rows PAGE: "name: what it may include besides itself", from the table of areas in lib/README.md, or from that of the
# folders in an area's page.
rows() {
  sed -nE 's/^\| \[([a-z]+)\]\(\1\/README\.md\) \| ([a-z, ]*) ?\|.*/\1: \2/p' "$1" | sed 's/,//g; s/ *$//'
}
areas=$(rows "$ROOT/lib/README.md")
layers=$(for area in "$ROOT"/lib/*/; do rows "$area/README.md"; done)

# Folders and their areas: "folder area".
homes=$(cd "$ROOT/lib" && printf '%s\n' */*/ | sed -E 's|(.*)/(.*)/|\2 \1|')

# Own includes of lib: "folder-of-file included-folder file".
own_includes() {
  grep -rHoE '^#include "[a-z]+/' --include='*.?pp' "$ROOT/lib" |
    sed -E "s|^$ROOT/lib/([a-z]+/([a-z]+)/[^:]+):#include \"([a-z]+)/|\2 \3 \1|"
}

# The same by areas: "area-of-file included-area file".
area_includes() {
  awk 'NR == FNR { home[$1] = $2; next } { print home[$1], home[$2], $3 }' <(echo "$homes") <(own_includes)
}

# "folder: all folders that it links", from the CMakeLists.txt of the areas. Tools are judged by these.
links=$(sed -nE 's/^quadrille_library\(([a-z]+)( USES ([a-z ]*[a-z]))?( Eigen3::Eigen)?( PRIVATE.*)?\)$/\1: \3/p' \
  "$ROOT"/lib/*/CMakeLists.txt | sed 's/ *$//')

@test "lib has a table of its areas, and each area one of its folders; no folder is in two areas" {
  local area
  run -0 comm -3 <(ls -d "$ROOT"/lib/*/ | xargs -n1 basename | sort) <(sed 's/:.*//' <<<"$areas" | sort)
  assert_output ''
  for area in $(sed 's/:.*//' <<<"$areas"); do
    run -0 comm -3 <(awk -v area="$area" '$2 == area { print $1 }' <<<"$homes" | sort) \
      <(rows "$ROOT/lib/$area/README.md" | sed 's/:.*//' | sort)
    assert_output ''
  done
  assert_equal "$(cut -d' ' -f1 <<<"$homes" | sort | uniq -d)" ""
}

# not_allowed TABLE INCLUDES: the files that include what the table does not let them.
not_allowed() {
  awk 'NR == FNR { sub(":", ""); for (i = 1; i <= NF; ++i) may[$1, $i] = 1; next }
    !(($1, $2) in may) { print $3 " includes " $2 "/" }' <(echo "$1") <(echo "$2")
}

@test "an area includes only the areas that the table names, a folder those folders of its area that its page names" {
  run -0 not_allowed "$areas" "$(area_includes)"
  assert_output ''
  run -0 not_allowed "$layers" "$(awk 'NR == FNR { home[$1] = $2; next } home[$1] == home[$2]' \
    <(echo "$homes") <(own_includes))"
  assert_output ''
}

# unused TABLE INCLUDES: what the table names and nothing includes.
unused() {
  awk 'NR == FNR { used[$1, $2] = 1; next }
    { sub(":", ""); for (i = 2; i <= NF; ++i) if (!(($1, $i) in used)) print $1 " does not include " $i "/" }' \
    <(echo "$2") <(echo "$1")
}

@test "an area uses every area that the table names, a folder every folder that its page names" {
  run -0 unused "$areas" "$(area_includes)"
  assert_output ''
  run -0 unused "$layers" "$(own_includes)"
  assert_output ''
}

# pairs TABLE: "what may include, what it may include".
pairs() {
  awk '{ sub(":", ""); for (i = 2; i <= NF; ++i) print $1, $i }' <<<"$1"
}

@test "a class has at most 150 lines in a header, 250 in a source file" {
  run -0 awk '
    FNR == 1 { begin = 0 }
    /^(template <.*> )?(class|struct) .*\{$/ { begin = FNR }
    /^\};/ && begin { lines = FNR - begin + 1
                     if (lines > (FILENAME ~ /hpp$/ ? 150 : 250)) print FILENAME " line " begin ": " lines
                     begin = 0 }' $(find "$ROOT/lib" -name '*.?pp')
  assert_output ''
}

@test "no table has a circle" {
  run -0 tsort <(pairs "$areas")
  run -0 tsort <(pairs "$layers")
}

@test "a folder links exactly the folders that it includes" {
  run -0 diff <(pairs "$links" | sort) <(own_includes | awk '$1 != $2 { print $1, $2 }' | sort -u)
}

# Own includes of lib's files, header and source taken as one: "folder/stem included-folder/stem".
stem_includes() {
  (cd "$ROOT/lib" && grep -rHoE '^#include "[a-z0-9_]+/[a-z0-9_]+' --include='*.?pp' .) |
    sed -E 's|^\./[a-z]+/([^.]+)\.[ch]pp:#include "(.*)|\1 \2|' | awk '$1 != $2' | sort -u
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
    sed -E "s|^\./[a-z]+/([a-z]+)/[^:]+:[0-9]+:namespace quadrille(::([a-z_]+))?.*|\1 \3|" | sort -u' "$ROOT"
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

# only_in AREA/FOLDER PATTERN: includes matching PATTERN occur in lib/AREA/FOLDER and in no other file.
only_in() {
  local files
  files=$(grep -rlE "^#include [<\"]$2" "$ROOT/lib" "$ROOT/tools" | grep -v "^$ROOT/lib/$1/") || return 0
  fail "$files include what only lib/$1 may include"
}

@test "kernels are included only in the folder that wraps them" {
  only_in cad/occ '[A-Za-z0-9_]+\.hxx'
  only_in field/triangulate 'CGAL/'
  only_in files/io '(H5|hdf5)[A-Za-z0-9]*\.h'
  only_in files/io 'nlohmann/'
  only_in files/cgns 'cgns[a-z_]*\.h'
  only_in files/netcdf 'netcdf[a-z_]*\.h>'
  only_in program/cli 'CLI/'
  only_in layout/quantize 'Cbc'
}

@test "a tool uses no kernel and only libraries of its line in tools/CMakeLists.txt" {
  local tool name uses folder
  for tool in "$ROOT"/tools/*.cpp; do
    name=$(basename "$tool" .cpp)
    uses=$(sed -nE "s/^quadrille_tool\($name(| .*)\)/\1/p" "$ROOT/tools/CMakeLists.txt")
    uses="${uses:- stage} check cli io model base "
    for folder in $(sed -nE 's|^#include "([a-z]+)/.*|\1|p' "$tool" | sort -u); do
      linked "$folder" "$uses" || fail "$name.cpp includes $folder/ and is not linked with it"
    done
  done
}

# linked FOLDER "LIBRARIES": FOLDER is one of them or a layer below one of them.
linked() {
  [[ $2 == *" $1 "* ]] && return
  local library
  for library in $2; do
    grep -qE "^$library:.* $1( |$)" <<<"$links" && return
  done
  return 1
}

# begins HEADER: a source of the same name includes it first, and so compiles it alone.
begins() {
  local source=${1%.hpp}.cpp
  [[ -f $source ]] && grep -m 1 '^#include' "$source" | grep -qF "\"${1#"$ROOT"/lib/*/}\""
}

@test "no source has more than 350 lines" {
  run -0 bash -c 'find "$1/lib" "$1/tools" \( -name "*.?pp" -o -name "*.js" \) -exec wc -l {} + | awk "\$1 > 350 && \$2 != \"total\""' - "$ROOT"
  assert_output ''
}

# Sources without a test under their own name, and why.
untested='
base/library_leaks          a text of builds with sanitizers, whose tests fail without it
base/version                one text
occ/occ_no_healing          settings of the kernel: without healing, occ_load_* read what the files say
occ/occ_quiet               switches the prints of the kernel off
occ/occ_write_brep          calls the writer of the kernel: read_face
api/fields                  passes settings to stages: tests/consumer
api/files                   the same
api/layouts                 the same
api/triangles               the same
stage/solver_table          a table: solver_check
stage/triangulate_face      calls two functions: cad2tri
refine/count_relaxer        seen through refine alone so far
refine/inverse_hessian      factored_hessian
refine/lower_error          seen through refine alone so far
refine/size_hessian         the other half of size_energy, whose gradient it differentiates: relax_problem
'

@test "each source that decides something has a test under its own name" {
  run -0 comm -3 <(awk '{ print $1 }' <<<"$untested" | sort -u | sed '/^$/d') \
    <(comm -23 <(cd "$ROOT/lib" && printf '%s\n' */*/*.cpp | sed -E 's|^[a-z]+/(.*)\.cpp$|\1|' | sort) \
      <(cd "$ROOT/tests/unit" && printf '%s\n' */*_test.cpp | sed 's/_test\.cpp$//' | sort))
  assert_output ''
}

@test "no main has more than 90 lines" {
  run -0 bash -c 'wc -l "$1"/tools/*.cpp | awk "\$1 > 90 && \$2 != \"total\""' - "$ROOT"
  assert_output ''
}

@test "every header compiles alone" {
  [[ -n ${QUADRILLE_LONG-} ]] || skip "long: part of tests/run --all"
  local area header headers=() roots=()
  for area in "$ROOT"/lib/*/; do roots+=("-I$area"); done
  while read -r header; do begins "$header" || headers+=("$header"); done < <(find "$ROOT/lib" -name "*.hpp" | sort)
  assert [ "${#headers[@]}" -gt 10 ]
  printf '%s\n' "${headers[@]}" >headers
  run -0 xargs -a headers -P "$(nproc)" -I{} g++ -std=c++20 -fsyntax-only -w "${roots[@]}" -isystem /usr/include/eigen3 \
    -isystem /usr/include/opencascade -isystem /usr/include/hdf5/serial -x c++ {}
}
