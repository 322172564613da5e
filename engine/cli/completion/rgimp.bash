# bash completion for rgimp. Verbs, options and what they take are read from the command's own --help
# and templates from `rgimp new --list`, so that nothing here has to follow them.

# What `rgimp [VERB] --help` says of options: lines "--name TYPE", TYPE missing for flags.
_rgimp_options() {
  "$@" --help 2>/dev/null | sed --quiet --regexp-extended '/^Options:/,/^$/ {
    s/^  (-[a-zA-Z],)?(--[a-z-]+)( (DIR|FILE[.a-z]*|N|KEY=VALUE))?( .*)?$/\2 \4/p
  }'
}

_rgimp_verbs() {
  "$1" --help 2>/dev/null |
    sed --quiet --regexp-extended '/^Subcommands:/,/^$/ s/^  ([a-z]+) .*/\1/p'
}

# Files or directories of a type; names with blanks stay whole.
_rgimp_paths() {
  local IFS=$'\n'
  compopt -o filenames
  case $1 in
    DIR) mapfile -t COMPREPLY < <(compgen -d -- "$2") ;;
    FILE.*) mapfile -t COMPREPLY < <(compgen -f -X "!*${1#FILE}" -- "$2"; compgen -d -- "$2") ;;
    FILE) mapfile -t COMPREPLY < <(compgen -f -- "$2") ;;
  esac
}

# The type that option $2 takes, among the lines of _rgimp_options in $1. -o stands for --output.
_rgimp_type_of() {
  local option=${2/#-o/--output} name type
  while read -r name type; do
    [[ $name == "$option" ]] && echo "$type" && return
  done <<<"$1"
}

_rgimp() {
  local command=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]}
  local verb=${COMP_WORDS[1]} options type
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$(_rgimp_verbs "$command")
      $(_rgimp_options "$command")" -- "$word")
    return
  fi
  options=$(_rgimp_options "$command" "$verb")
  type=$(_rgimp_type_of "$options" "${COMP_WORDS[COMP_CWORD - 1]}")
  if [[ -n $type ]]; then
    _rgimp_paths "$type" "$word"
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${options//$'\n'/ }" -- "$word" | grep -e '^-')
  elif [[ $verb == new ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("$command" new --list 2>/dev/null |
      sed 's/ .*//')" -- "$word")
  else
    type=$("$command" "$verb" --help 2>/dev/null |
      sed --quiet --regexp-extended '/^Positionals:/,/^$/ s/^  [A-Z]+ ([A-Za-z.]+).*/\1/p')
    _rgimp_paths "$type" "$word"
  fi
} && complete -F _rgimp rgimp
