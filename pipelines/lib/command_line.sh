# shellcheck shell=sh
# The options of quadmesh itself; those of the stages are in stage_options.sh. Each function that takes a word of the
# command line sets $taken, the number of words: 0 if it is no option of its own.
shape='' out='' workdir='' report='' face='' names='' heal='' blunt='' healed='' verbose=false quiet='' version=''
fit='' html='' of_points='' max_seconds='' max_memory='' threads='' given_nodes='' first_stage='' last_stage='' dry_run=''
own_flags='--help --verbose --quiet --version --dry-run'
own_values='--output --workdir --html --report --max-seconds --max-memory --threads --face --boundary-names --name
  --region-name --periodic --offset --heal-tolerance --fit-tolerance --blunt --write-healed --nodes --from
  --until --farfield --wake --chord'

mistake() { printf '%s\n' "quadmesh: $1" "try 'quadmesh --help'" >&2; exit 2; }

# needs_value OPTION [VALUE...]: the value may be empty or begin with one -, but must not be an option.
needs_value() {
  [ $# -ge 2 ] || mistake "$1 needs a value"
  case $2 in --?*) mistake "$1 needs a value, not the option $2" ;; esac
}

# long_name OPTION: sets $option to the long name of a short one.
long_name() {
  case $1 in
    -o) option=--output ;;
    -v) option=--verbose ;;
    -q) option=--quiet ;;
    -h) option=--help ;;
    *) option=$1 ;;
  esac
}

is_among() { case " $2 " in *[[:space:]]"$1"[[:space:]]*) ;; *) return 1 ;; esac }

# take_own_option OPTION [WORD...]
take_own_option() {
  taken=0
  long_name "$1"
  if is_among "$option" "$own_flags"; then
    take_flag "$option" && taken=1
  elif is_among "$option" "$own_values"; then
    needs_value "$@"
    take_value "$option" "$2" && taken=2
  fi
}

take_flag() {
  case $1 in
    --help) usage; exit ;;
    --verbose) verbose=true ;;
    --quiet) quiet=yes ;;
    --version) version=yes ;;
    --dry-run) dry_run=yes ;;
  esac
}

take_value() {
  case $1 in
    --output) out=$2 ;;
    --workdir) workdir=$2 ;;
    --html) html=$2 ;;
    --report) report=$2 ;;
    --max-seconds) max_seconds=${2:-none} ;;
    --max-memory) max_memory=${2:-none} ;;
    --threads) threads=${2:-none} ;;
    --nodes)
      case $2 in
        auto | none | fewest | field) takers=critpoints && choose_option "$@" ;;
        *) given_nodes=$2 ;;
      esac ;;
    --farfield | --wake | --chord) of_points=$1 takers=points2step && choose_option "$@" ;;
    --from) first_stage=$2 ;;
    --until) last_stage=$2 ;;
    *) take_value_of_cad2tri "$@" ;;
  esac
}

take_value_of_cad2tri() {
  of_cad2tri=$1
  case $1 in
    --face) face=$2 ;;
    --boundary-names) names=$2 ;;
    --name | --region-name | --periodic | --offset) takers=cad2tri && choose_option "$1" "$2" ;;
    --heal-tolerance) heal=$2 ;;
    --fit-tolerance) fit=$2 ;;
    --blunt) blunt=$2 ;;
    --write-healed) healed=$2 ;;
  esac
}

# take_stage_option OPTION [WORD...]: an option of the stages, passed on; anything else is a mistake.
take_stage_option() {
  require_tools
  find_stages "$1"
  [ -n "$takers" ] || unknown_option "$1"
  if [ "$kind" = flag ]; then
    choose_option "$1"
    taken=1
  else
    needs_value "$@"
    choose_option "$1" "$2"
    taken=2
  fi
}

# unknown_option OPTION: exits with the nearest one.
unknown_option() {
  # shellcheck disable=SC2046,SC2086 # words
  nearest=$(python3 -ISB "$lib/nearest_word.py" "$1" $own_values $own_flags \
    $(printf '%s\n' "$known" | sed 's/^[^ ]* \([^ ]*\) .*/\1/') 2>/dev/null)
  mistake "unknown option $1${nearest:+: did you mean $nearest?}"
}

# require_no_value OPTION: after "OPTION=VALUE".
require_no_value() {
  if is_among "$1" "$own_flags"; then mistake "$1 takes no value"; fi
}

take_shape() {
  [ -z "$shape" ] || mistake "more than one shape: $shape and $1"
  [ -n "$1" ] || mistake "the name of the shape is empty"
  shape=$1
}
