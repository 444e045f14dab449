# Follows what `touchstone --completion` prints of the program: _touchstone_operations, their names;
# _touchstone_values, the options that take a value; _touchstone_words COMMAND, what may follow it.
_touchstone() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} path=touchstone before="" i
  for ((i = 1; i < COMP_CWORD; i++)); do
    if [ -n "$(_touchstone_words "$path ${COMP_WORDS[i]}")" ]; then path="$path ${COMP_WORDS[i]}"; fi
  done
  COMPREPLY=()
  if [ "$previous" = --ops ]; then
    # Names with commas: the last one is completed.
    case $current in *,*) before="${current%,*}," ;; esac
    COMPREPLY=($(compgen -P "$before" -W "all $_touchstone_operations" -- "${current##*,}"))
    return
  fi
  case " $_touchstone_values " in *" $previous "*) return ;; esac  # a value: bash's own completion, of files
  COMPREPLY=($(compgen -W "$(_touchstone_words "$path")" -- "$current"))
}
complete -o default -F _touchstone touchstone
