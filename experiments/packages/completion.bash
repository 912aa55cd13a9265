# SPDX-License-Identifier: BSD-3-Clause
# Completion of the flags of gmapping_spa's programs in bash. The build puts tables of flags and values
# into it: _gmapping_spa_flags[PROGRAM] and _gmapping_spa_values[PROGRAM/FLAG].

# Completes what is after --FLAG= or after --FLAG and a blank. $3 stands before each reply.
_gmapping_spa_complete_value() {
  local values=$1 word=$2 prefix=$3 names=() replies=() value
  for value in $values; do
    case $value in
      FILES)
        mapfile -t names < <(compgen -f -- "$word")
        compopt -o filenames 2>/dev/null
        ;;
      FOLDERS)
        mapfile -t names < <(compgen -d -- "$word")
        compopt -o filenames 2>/dev/null
        ;;
      "$word"*) replies+=("$value") ;;
    esac
  done
  replies+=("${names[@]}")
  COMPREPLY=("${replies[@]/#/$prefix}")
}

_gmapping_spa_complete_flag() {
  local program=$1 word=$2 flag
  COMPREPLY=()
  for flag in ${_gmapping_spa_flags[$program]}; do
    [[ $flag == "$word"* ]] || continue
    # --noFLAG shows up when it is asked for: it would double the list.
    [[ $flag == --no* && $word != --no* &&
      " ${_gmapping_spa_flags[$program]} " == *" --${flag#--no} "* ]] && continue
    COMPREPLY+=("$flag")
  done
  [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
  return 0
}

# Bash calls it with the command and what stands before the cursor since the last of COMP_WORDBREAKS, of which
# = is one unless somebody took it out.
_gmapping_spa_complete() {
  local program=${1##*/} word=${COMP_WORDS[COMP_CWORD]} flag='' prefix=''
  local before=${COMP_WORDS[COMP_CWORD - 1]}
  if [[ $word == -*=* ]]; then
    flag=${word%%=*} prefix=${word%%=*}= word=${word#*=}
  elif [[ $word == = ]]; then
    flag=$before word=''
  elif [[ $before == = && COMP_CWORD -ge 2 ]]; then
    flag=${COMP_WORDS[COMP_CWORD - 2]}
  elif [[ $before == -* && $word != -* && " ${_gmapping_spa_flags[$program]} " == *" $before= "* ]]; then
    flag=$before
  fi
  if [[ -n $flag ]]; then
    flag=${flag#-}
    _gmapping_spa_complete_value "${_gmapping_spa_values[$program/${flag#-}]-}" "$word" "$prefix"
  else
    _gmapping_spa_complete_flag "$program" "$word"
  fi
}
