// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/completion_script.h"

#include "tb/base/nearest.h"

namespace racebeam {

namespace {

// bash begins a word anew behind = and :, so what is before them is cut off again.
constexpr const char* Bash = R"(# bash completion for racebeam
_racebeam() {
  local before=${COMP_LINE:0:COMP_POINT} value words
  read -a words <<<"$before"
  [[ $before != *[[:space:]] ]] || words+=('')
  local current=${words[-1]}
  local tail=${current##*[=:]}
  local cut=${current%"$tail"}
  COMPREPLY=()
  while IFS=$'\t' read -r value _; do
    case $value in
    :files) mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "$tail") ;;
    :folders) mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "$tail") ;;
    *)
      value=${value#"$cut"}
      [[ $value != *' '* ]] || printf -v value %q "$value"
      COMPREPLY+=("$value")
      ;;
    esac
    [[ $value != :f* ]] || compopt -o filenames 2>/dev/null
  done < <("${1/#\~/$HOME}" --complete "${words[@]:1}" 2>/dev/null)
  [[ ${COMPREPLY[*]} != *= ]] || compopt -o nospace 2>/dev/null
}
complete -F _racebeam racebeam
)";

constexpr const char* Zsh = R"(#compdef racebeam
# zsh completion for racebeam
_racebeam() {
  local line paths
  local -a found open
  for line in "${(@f)$("${(Q)words[1]}" --complete "${(@Q)words[2,CURRENT]}" 2>/dev/null)}"; do
    case $line in
    '') ;;
    :files) paths=_files ;;
    :folders) paths='_files -/' ;;
    *=$'\t'*) open+=("${${line%%$'\t'*}//:/\\:}") ;;
    *) found+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}") ;;
    esac
  done
  (( $#found )) && _describe racebeam found
  (( $#open )) && _describe racebeam open -S ''
  [[ -z $paths ]] || { compset -P '*='; ${=paths} }
}
_racebeam "$@"
)";

constexpr const char* Fish = R"(# fish completion for racebeam
function __racebeam_complete
    set -l words (commandline -opc)
    for line in ($words[1] --complete $words[2..] (commandline -ct) 2>/dev/null)
        switch $line
            case :files
                set -l before (string replace -r '[^=]*$' '' -- (commandline -ct))
                set -l paths (__fish_complete_path (string replace -r '.*=' '' -- (commandline -ct)))
                printf '%s\n' $before$paths
            case :folders
                __fish_complete_directories (commandline -ct)
            case '*'
                echo $line
        end
    end
end
complete -c racebeam -f -a '(__racebeam_complete)'
)";

struct Script {
  const char *shell, *text;
};
constexpr Script Scripts[] = {{"bash", Bash}, {"fish", Fish}, {"zsh", Zsh}};

}  // namespace

std::vector<std::string> completion_shells() {
  std::vector<std::string> shells;
  for (const Script& one : Scripts) shells.emplace_back(one.shell);
  return shells;
}

std::string completion_script(const std::string& shell) {
  for (const Script& one : Scripts)
    if (one.shell == shell) return one.text;
  throw unknown_name("shell", shell, completion_shells());
}

}  // namespace racebeam
