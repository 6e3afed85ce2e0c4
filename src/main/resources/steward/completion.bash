
# Bash takes words apart at COMP_WORDBREAKS: 'builtin:veteran' arrives as three words, and so does '--accuracy=exact'.
# Puts together what a colon has parted, leaves out '--option=' but for the option and 'NAME=' before a bot, and returns
# what comes after the last colon, because that is what bash replaces. '--' is no parameter.
function _steward_words() {
  local -a words=()
  local word joined="" i
  for (( i = 0; i <= COMP_CWORD; i++ )); do
    word=${COMP_WORDS[i]}
    local last=$(( ${#words[@]} - 1 ))
    if (( last > 0 )) && [[ "$word" == ":" || -n "$joined" ]]; then
      words[last]+=$word
      joined=""
      [[ "$word" == ":" ]] && joined=yes
    elif (( last > 0 )) && [[ "$word" == "=" ]]; then
      [[ "${words[last]}" == -* ]] || unset "words[last]"
      (( i == COMP_CWORD )) && words+=("")
    elif [[ "$word" != "--" ]] || (( i == COMP_CWORD )); then
      words+=("$word")
    fi
  done
  local whole=${words[${#words[@]} - 1]}
  local COMP_WORDS=("${words[@]}")
  local COMP_CWORD=$(( ${#words[@]} - 1 ))
  _complete_steward
  if [[ "$whole" == *:* && "$COMP_WORDBREAKS" == *:* ]]; then
    local before="${whole%"${whole##*:}"}"
    for (( i = 0; i < ${#COMPREPLY[@]}; i++ )); do
      COMPREPLY[i]=${COMPREPLY[i]#"$before"}
    done
  fi
}

# Where nothing is found, files are completed.
if [ -n "$ZSH_VERSION" ]; then
  complete -F _complete_steward -o default steward steward.sh steward.bash
else
  complete -F _steward_words -o default steward steward.sh steward.bash
fi
