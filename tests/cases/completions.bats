# Completions for bash, zsh and fish, made from --help-all (pipelines/completions).
load ../tools/common

commands="cad2chart cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport stageview stagecheck quadmesh
  quadplace points2step drawing2step quadbench"

# completion SHELL NAME: what pipelines/completions prints for the command.
completion() {
  local command=$BIN/$2
  [[ -x $command ]] || command=$ROOT/pipelines/$2
  QUADRILLE_BIN=$BIN "$ROOT/pipelines/completions" "$1" "$command"
}

# complete_bash WORD...: the completions of the last word, one a line.
complete_bash() {
  completion bash "$1" >completion.bash
  bash --norc -c '. ./completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _quadrille_$1
    printf "%s\n" "${COMPREPLY[@]}"' - "$@"
}

@test "bash completes options, choices and nothing where a value is free" {
  run -0 complete_bash separatrix --me
  assert_output $'--merge-angle\n--merge-distance'
  run -0 complete_bash separatrix --layout ''
  assert_output $'traced\nquantized\nauto\nt-mesh\nmidpoint'
  run -0 complete_bash separatrix --layout q
  assert_output quantized
  run -0 complete_bash separatrix --step ''
  assert_output ''
  run -0 complete_bash quadmesh --max
  assert_line --index 0 --max-seconds
  assert_line -- --max-deviation
  run -0 complete_bash quadmesh --format n
  assert_output nektar
  run -0 complete_bash quadexport --format ''
  assert_line --index 0 auto
  assert_line --index 1 msh
  assert_equal "${lines[-1]}" step
}

@test "every option of every --help-all is completed in every shell" {
  local name option
  for name in $commands; do
    for shell in bash zsh fish; do completion $shell "$name" >"$name.$shell"; done
    for option in $(QUADRILLE_BIN=$BIN "$( (command -v "$name" || echo "$ROOT/pipelines/$name") | tail -1)" --help-all |
      sed '/^EXIT CODES$/,$d' | sed -nE 's/^  (-[a-z], )?(--[a-z0-9-]+).*/\2/p' | sort -u); do
      run -0 grep -cE -- "[ ']$option[ ']" "$name.bash"
      run -0 grep -cE -- "[ ,']$option[]}' )]" "$name.zsh"
      run -0 grep -cE -- " -l ${option#--} " "$name.fish"
    done
  done
}

@test "the same help gives the same completion; a mistake is refused" {
  for shell in bash zsh fish; do assert_equal "$(completion $shell critpoints)" "$(completion $shell critpoints)"; done
  run -1 "$ROOT/pipelines/completions" tcsh critpoints
  assert_output "usage: completions bash|zsh|fish COMMAND"
}

@test "bash reads every completion, and shellcheck finds no fault" {
  for name in $commands; do
    completion bash "$name" >file
    run -0 bash -n file
    assert_output ''
    if command -v shellcheck >/dev/null; then run -0 shellcheck -s bash file; fi
  done
}

@test "zsh reads every completion and completes a choice" {
  command -v zsh || skip "no zsh"
  for name in $commands; do
    completion zsh "$name" >"_$name"
    run -0 zsh -n "_$name"
    assert_output ''
  done
  cat >typed <<'END'
zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z "PROMPT=; fpath=($PWD \$fpath); autoload -Uz compinit; compinit -u -d $PWD/dump; print REA''DY"
zpty -r z out '*READY*' # printed, not the echo of the line
zpty -w -n z $'separatrix --layout quan\t'
zpty -r z out '*quantized*'
print -r -- "$out"
END
  run -0 timeout 60 zsh -f typed
  assert_output --partial quantized
}

@test "fish reads every completion and completes a choice" {
  command -v fish || skip "no fish"
  export HOME=$PWD
  for name in $commands; do
    completion fish "$name" >"$name.fish"
    run -0 fish --no-execute "$name.fish"
    assert_output ''
  done
  run -0 fish -c 'source separatrix.fish; complete -C "separatrix --layout q"'
  assert_line --regexp '^quantized'
  run -0 fish -c 'source quadmesh.fish; complete -C "quadmesh --max-s"'
  assert_line --regexp '^--max-seconds'
}
