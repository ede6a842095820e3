#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails when the source tree breaks a rule of the house that a compiler does not see.
# Usage: guards.sh [SOURCE_DIR]
set -euo pipefail
cd "${1:-"$(dirname "${BASH_SOURCE[0]}")/.."}"

faults=0
fault() { # WHAT LINES: reports the lines found, if any, as a paragraph
  [ -z "$2" ] && return
  faults=1
  printf '%s:\n%s\n\n' "$1" "$2" >&2
}

# Heights of the rooms: a room includes only itself and rooms below. toolpath: former places of headers.
declare -A level=([core]=0 [common]=1 [search]=2 [graph]=3 [fit]=4 [cleaning]=5 [surface]=6 [features]=7 [collision]=8 [geodesic]=8
  [mesh]=8 [spiral]=9 [ridge]=9 [drive]=10 [cutter]=11 [machine]=12 [verify]=13 [planning]=14 [io]=15 [visualization]=16 [toolpath]=16)

library=pcl_spiral
[ -d "$library" ] || { echo "no folder $library in $PWD: give the source directory" >&2; exit 2; }

fault "core stands on Eigen alone; these lines include PCL" \
  "$(grep -rnE '#[[:space:]]*include[[:space:]]*[<"]pcl/' $library/include/pcl_spiral/core $library/src/core || true)"

for folder in "$library"/include/pcl_spiral/*/ "$library"/src/*/; do
  room=${folder%/} room=${room##*/}
  [ -n "${level[$room]:-}" ] || fault "folder without a place in the layers (give it one in cmake/guards.sh)" "$folder"
done
while IFS=: read -r file line text; do # from a string: of a pipe read takes one byte at a time
  room=${file#"$library"/src/} room=${room#"$library"/include/pcl_spiral/} room=${room%%/*}
  [[ $text =~ [\<\"](pcl_spiral/)?([a-z_]+)/ ]] || continue
  included=${BASH_REMATCH[2]}
  [ "$included" = "$room" ] || [ "${level[$included]:-99}" -lt "${level[$room]:-99}" ] ||
    fault "$room includes $included, which does not stand below it" "$file:$line:$text"
done <<<"$(grep -rnE '#[[:space:]]*include[[:space:]]*([<"]pcl_spiral/|")[a-z_]+/' "$library"/include/pcl_spiral/*/ "$library"/src/*/ || true)"

# Two classes of one name in two headers are one class to the linker, which then calls the functions of the other.
fault "classes with the same name in two headers" \
  "$(find "$library/src" "$library/include" -name '*.h' -o -name '*.hpp' | sort |
    xargs grep -HoE '^(struct|class|enum class) [A-Z][A-Za-z0-9]+ *(final *)?[:{]' |
    sed -E 's/^([^:]*):(enum )?(struct|class) ([A-Za-z0-9]+).*/\4 \1/' | sort |
    awk '$1 == name { print before; print } { name = $1; before = $0 }')"

# Folders within a room (. is the room itself): each includes its own files and those of the folders named before it.
declare -A parts=([spiral]="outlines lines field loops turns path linking published ." [io]=". read write post report"
  [visualization]=". viewer")
reaches() { # ROOM OWN THEIRS: whether files of folder OWN may include those of folder THEIRS
  [ "$2" = "$3" ] && return
  [ "$1" = io ] && [ "$3" != . ] && return 1 # readers, writers, posts and reports stand side by side
  [[ " ${parts[$1]} " =~ \ $3\ (.*\ )?$2\  ]]
}
for folder in "$library"/src/*/*/; do
  room=${folder#"$library"/src/} own=${folder%/}
  room=${room%%/*} own=${own##*/}
  case " ${parts[$room]:-.} " in *" $own "*) ;; *) fault "folder without a place in its room (give it one in cmake/guards.sh)" "$folder" ;; esac
done
while IFS=: read -r file line text; do
  place=${file#"$library"/src/} room=${file#"$library"/src/}
  room=${room%%/*} own=${place#*/}
  [[ $own = */* ]] && own=${own%/*} || own=.
  [[ $text =~ \"([a-z_/]+\.h)\" ]] && theirs=${BASH_REMATCH[1]} || continue
  [ "${theirs%%/*}" = "$room" ] || continue
  theirs=${theirs#*/}
  [[ $theirs = */* ]] && theirs=${theirs%/*} || theirs=.
  reaches "$room" "$own" "$theirs" || fault "$room/$own includes $room/$theirs, which does not stand below it" "$file:$line:$text"
done <<<"$(grep -rnE '#[[:space:]]*include[[:space:]]*"(spiral|io|visualization)/' $library/src || true)"

# What a user names: a new header goes to src, or to impl where a template's body needs it, unless it is put into the list on purpose.
# Former places of headers have a list of their own: such a header has one include and no code.
public_headers() {
  (cd $library/include/pcl_spiral && find . -name '*.h' -not -path '*/impl/*' | sed 's|^\./||' | LC_ALL=C sort)
}
fault "public headers that are in neither cmake/public_headers.txt nor cmake/forwarding_headers.txt, or there alone" \
  "$(diff <(public_headers) <(LC_ALL=C sort cmake/public_headers.txt cmake/forwarding_headers.txt) |
     sed -n "s|^[<>] |$library/include/pcl_spiral/|p" || true)"
while read -r header; do
  [ "$(grep -cvE '^(//|/\*\*| \*|#pragma once|$)' "$library/include/pcl_spiral/$header")" = 1 ] ||
    fault "forwarding header with more than one include" "$library/include/pcl_spiral/$header"
done <cmake/forwarding_headers.txt

fault "results are named Report" "$(grep -rnE '^(struct|class) [A-Za-z]+(Figures|Counts)\b' $library/include $library/src || true)"

fault "newer PCL base classes have members of these names; choose others" \
  "$(grep -rnE '(^|[^.])\b(threads_|chunk_size_)\b' $library/include $library/src --include='*.h' --include='*.hpp' --include='*.cpp' || true)"

fault "messages of the library name setters, never a program's options" \
  "$(grep -rnE '"[^"]*--[a-z]' $library/include $library/src --include='*.h' --include='*.hpp' --include='*.cpp' || true)"

# What a diagnostic has as a field: names of C++, units, and words for which a program has others.
library_literals() { # PATTERN: lines of code of the library with a literal that has it
  grep -rnE "^([^/*\"]|/[^/*]|\* )*\"([^\"\\\\]|\\\\.)*$1" $library/src $library/include --include='*.h' --include='*.hpp' --include='*.cpp' |
    grep -vE "^$library/src/(visualization|verify/figure_|verify/verification_figures|io/(report|write|post)/)|PCL_(ERROR|WARN)|invalid_argument|deprecated\(|settings\.at\(|:[0-9]+:[[:space:]]*\*|pcd_origin_mark" || true
}
fault "names of settings typed into a sentence; put them in braces, which each face names its own way" \
  "$(library_literals '(^|[^A-Za-z{:"])((set|add|clear)[A-Z][A-Za-z]+[^A-Za-z]|(ReadOptions|Limits|MeshSettings)::)')"
fault "units typed into a sentence; put them in braces" "$(library_literals '[ (](mm|mm2|mm/min|mm/s2|degrees)([ ;:,.)"]|$)' | grep -v 'are degrees, longitude')"
fault "fields in a text that is no diagnostic: they would be shown with their braces" \
  "$(library_literals '\{[a-zA-Z]' | grep -E 'std::string(\(| [a-z_]+ = | [a-z_]+\()"' || true)"
lines_with() { # FOLDER...: the lines there that have a field of stdin in braces
  sed 's/.*/{&}/' | grep -rnFf - "$@"
}
unknown_fields() {
  { library_literals '\{'; grep -rnE '"[^"]*\{[a-zA-Z]' $library/tools --include='*.cpp' --include='*.h' | grep -vE 'figures_table|PictureKind::|std::regex'; } | grep -oE '"([^"\\]|\\.)*"' | sed 's/{{//g; s/}}//g' | grep -oE '\{[^{}]*\}' | tr -d '{}' | sort -u |
    grep -vE '^(mm|mm2|mm/min|mm/s2|degrees|number|place|direction|name|((set|add|clear)[A-Z]|[A-Z][a-z]+[A-Z]|[A-Z][A-Za-z]+::|pcl::|readCloud).*|Scale it to mm| and )$' |
    comm -23 - <(grep -oE '\{"[^"]*",' $library/tools/terminal/vocabulary.cpp | sed 's/^{"//; s/",$//' | sort -u) | lines_with $library
}
fault "fields of sentences that are neither names of C++, units nor in tools/terminal/vocabulary.cpp" "$(unknown_fields || true)"
fault "sentences searched or cut; use the fields of the diagnostic" \
  "$(grep -rnE '(message|what|text|diagnostic)\(\)\.(find|substr|replace|compare)\(|warnings(\(\))?\.front\(\)' $library || true)"
fields_of_programs() { # fields for which programs have words: of their own, or the option of a setting
  { grep -oE '\{"[^"]*",' $library/tools/terminal/vocabulary.cpp
    grep -rhoE '(Setting\(|^ *)"[a-z_]+", "[^"]*",' $library/src $library/include; } | sed -E 's/.*"([^"]*)",$/\1/' | sort -u
}
unnamed_setters() { # that the spiral names, but no program has an option for; inputs and tolerances of single classes have none
  grep -rhoE '\{(set|add|clear)[A-Z][^}]*\}' $library/src/spiral $library/include/pcl_spiral/spiral/impl | tr -d '{}' |
    grep -vE '^set(Input[A-Za-z]*|Tolerance|FitTolerance)$|^clearRadialLines$' | sort -u | comm -23 - <(fields_of_programs) |
    lines_with $library/src/spiral $library/include/pcl_spiral/spiral
}
fault "setters in sentences without an option in a table of settings or in tools/terminal/vocabulary.cpp" "$(unnamed_setters || true)"
missing_setters() { # that planners name, but that no class a planner is made of has
  grep -rhoE '\{(set|add|clear)[A-Z][A-Za-z]*\}' $library/src/planning $library/include/pcl_spiral/planning | tr -d '{}' | sort -u |
    comm -23 - <(grep -rhoE '\b(set|add|clear)[A-Z][A-Za-z]*\(' $library/include/pcl_spiral/{planning,spiral,ridge,drive,surface,mesh/impl} |
      tr -d '(' | sort -u) |
    lines_with $library/src/planning $library/include/pcl_spiral/planning
}
fault "setters in sentences of planners that no planner has" "$(missing_setters || true)"

fault "planning steered by exceptions; a try gives a refusal" \
  "$(grep -rnE '\b(try|catch)\b *[({]' $library/src/planning $library/include/pcl_spiral/planning $library/tools --include='*.cpp' --include='*.h' --include='*.hpp' |
     grep -E "^$library/(src|include)/|/planning\.cpp:" || true)"

fault "constants changed by a cast; give those who need another value a copy that shares the rest" \
  "$(grep -rn 'const_cast' $library --include='*.cpp' --include='*.h' --include='*.hpp' || true)"

flags='-march=native|-mavx|-ffast-math|-Ofast|PCL_NO_PRECOMPILE'
fault "flags that break PCL's ABI, the same bytes everywhere, or the compile time" \
  "$(find . -name 'build*' -prune -o -path ./.git -prune -o -type f \
       \( -name CMakeLists.txt -o -name '*.cmake' -o -name '*.in' -o -name CMakePresets.json -o -path ./.ci/run \) -print0 |
     xargs -0 grep -nE -e "$flags" || true)"
fault "pragmas that break the same bytes everywhere" \
  "$(grep -rnE 'pragma.*(fast-math|Ofast|march=)|attribute.*(fast-math|Ofast)' $library examples || true)"

trees=("$library" examples)
[ ! -d test ] || trees+=(test)
fault "lines of over 140 characters" \
  "$(find "${trees[@]}" \( -name '*.h' -o -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 awk 'length > 140 { print FILENAME ":" FNR }')"
fault "files without the line of their licence" \
  "$(find "${trees[@]}" \( -name '*.h' -o -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 grep -L 'SPDX-License-Identifier: BSD-3-Clause' || true)"
clang_format=${CLANG_FORMAT:-clang-format}
if "$clang_format" --version 2>/dev/null | grep -q 'version 14'; then # others break lines elsewhere
  fault "files that clang-format would change" \
    "$(find "${trees[@]}" \( -name '*.h' -o -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 -P 2 -n 40 "$clang_format" --dry-run 2>&1 |
       grep -oE '^[^:]+' | sort -u || true)"
fi

# Examples are to be read at a glance; the whole chain of stages takes a few lines more, programs of pictures twice, and so does a
# chain with filters and features of PCL.
long_examples() {
  local file most
  for file in examples/example_*.cpp; do
    case "$file" in
      */example_stage_by_stage.cpp) most=71 ;;
      */example_*_pictures.cpp | */example_pcl_pipeline.cpp) most=111 ;;
      *) most=60 ;;
    esac
    awk -v most="$most" 'END { if (NR > most) print FILENAME ": " NR " lines, allowed are " most }' "$file"
  done
}
fault "examples that are too long" "$(long_examples)"

# The code on the pages is tried by a build: each line of it stands in an example.
untried_lines() {
  find $library/doc -name '*.md' -print0 | xargs -0 -r perl -e '
    my %tried;
    for my $example (glob "examples/*.cpp") {
      open my $file, "<", $example or die;
      s/^\s+|\s+$//g, $tried{$_} = 1 while <$file>;
    }
    while (<>) {
      if (/^```/) { $code = /^```cpp/; next }
      s/^\s+|\s+$//g;
      print "$ARGV: $_\n" if $code && $_ ne "" && !$tried{$_};
    }'
}
fault "lines of code that are in no example" "$(untried_lines)"

# Constants on the pages are those of the code: | `name = value, name = value` in `src/room/file.cpp` | ...
stale_constants() {
  perl -ne '
    next unless /^\| `([^`]+ = [^`]+)` in `([^`]+)` \|/;
    my ($constants, $name) = ($1, $2);
    my $code = "";
    if (open my $file, "<", "'$library'/$name") { local $/; $code = <$file> }
    print "$ARGV: $constants in $name\n" unless $code =~ /\b\Q$constants\E\s*[;,]/' $library/doc/constants*.md
}
fault "constants on a page that the code has no more, or with another value" "$(stale_constants)"

# Files that the pages name; a name alone is that of a file in any folder.
missing_files() {
  local tree
  tree=$(find $library examples cmake test README.md .github -type f 2>/dev/null || true)
  perl -ne '
    BEGIN { my $list = shift; $list =~ s{^}{/}mg; $tree = "$list\n"; $has_test = $list =~ m{^/test/}m }
    while (/`([a-z0-9_.\/]+\.(?:h|hpp|cpp|cmake|sh|md|yml|ya?ml|py|txt))`/g) {
      my $name = $1;
      next if $name =~ m{^foo\.} || ($name =~ m{^test/} && !$has_test);
      print "$ARGV: $name\n" unless $tree =~ m{/\Q$name\E\n};
    }' "$tree" $library/doc/{code_map,contributing,development}.md
}
fault "files that a page names and that are not there" "$(missing_files)"

fault "pages of over 150 lines (settings.md is made from the tables)" \
  "$(find $library/doc -name '*.md' ! -name settings.md | sort | xargs awk 'FNR == 151 { print FILENAME }')"

# Doxygen takes any word after \\p; the declaration that follows has to know it.
wrong_names() {
  find $library/include -name '*.h' -print0 | xargs -0 perl -0777 -ne '
    my $line = 1;
    for my $block (split m{/\*\*}) {
      my ($words, $declaration) = split m{\*/}, $block, 2;
      $declaration =~ s/(;|(?<!= )\{).*//s if defined $declaration;
      for my $name ($words =~ /\\p\s+(\w+)/g) {
        print "$ARGV:$line: \\p $name\n" unless ($declaration // $name) =~ /\b$name\b/;
      }
      $line += $block =~ tr/\n//;
    }'
}
fault "names that are not in the declaration under the comment" "$(wrong_names)"

# Doxygen has no warning for values of an enumeration without a comment.
bare_values() {
  find $library/include -name '*.h' -not -path '*/impl/*' -print0 | xargs -0 awk '
    /^ *enum class .*\{.*[A-Za-z]/ { print FILENAME ":" FNR ":" $0; next }
    /^ *enum class / { inside = 1; next }
    /};/ { inside = 0 }
    inside && /^ *[A-Za-z]/ && !/\/\/\/</ { print FILENAME ":" FNR ":" $0 }'
}
fault "values of a public enumeration without a comment (one a line, each with ///<)" "$(bare_values)"

exit $faults
