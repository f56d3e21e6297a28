# shellcheck shell=sh
# Options of the stages on the command line of a pipeline: which stage has an option is found by asking the tools of
# $stages (--list-options); options are kept for their stages and passed on.
known=''                   # lines "TOOL --OPTION value" or "TOOL --OPTION flag", once the tools were asked
chosen=''                  # "TOOL WORD" for each word to pass on, each followed by a separator
separator=$(printf '\036') # a character that no option contains

# find_stages OPTION: sets $takers to the tools that have the option, and $kind to value or flag.
find_stages() {
  [ -n "$known" ] || known=$(for tool in $stages; do "$tool" --list-options || exit; done) || exit
  takers='' kind=value
  while read -r tool option what; do
    [ "$option" != "$1" ] || takers="$takers $tool" kind=$what
  done <<END
$known
END
}

# choose_option OPTION [VALUE]: keeps it for the tools that find_stages found.
choose_option() {
  for tool in $takers; do
    for word in "$@"; do chosen=$chosen"$tool $word"$separator; done
  done
}

# chosen_value TOOL OPTION: prints the value that was chosen for the tool.
chosen_value() {
  case $separator$chosen in
    *"$separator$1 $2$separator"*)
      value=${chosen#*"$1 $2$separator$1 "}
      printf '%s\n' "${value%%"$separator"*}" ;;
  esac
}

# with_options TOOL COMMAND...: runs the command with the options behind it that were chosen for the tool.
with_options() {
  receiver=$1
  shift
  set -f && IFS=$separator
  for word in $chosen; do
    case $word in "$receiver "*) set -- "$@" "${word#* }" ;; esac
  done
  set +f && unset IFS
  "$@"
}

# check_options TOOL INPUT [ARGUMENT...]: exits with 2 and the tool's message, as one of this command, if these arguments
# or the options chosen for it contain a mistake. With an empty INPUT the tool ends at once, and with 2 only after a mistake.
check_options() {
  [ $# -gt 2 ] || case $separator$chosen in *"$separator$1 "*) ;; *) return ;; esac
  message=$(with_options "$1" "$@" 2>&1 </dev/null)
  [ $? -ne 2 ] || { printf '%s\n' "$message" | sed "s/^$1: /${0##*/}: /; s/^try '$1 /try '${0##*/} /" >&2; exit 2; }
}
