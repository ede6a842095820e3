# SPDX-License-Identifier: BSD-3-Clause
# Makes the man page of a program of what it prints for --help:
#   what it is; "  synopsis" and "  examples", two blanks before each; text; groups of options, each under its "name:".
# Usage: PROGRAM --help | awk -v name=PROGRAM -v version=V -v date=D -v others="PROGRAM ..." -v docs=DIR -f man_page.awk
# Fails when the help lacks a part that a page has to have.

function roff(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  return (text ~ /^[.']/ ? "\\&" : "") text
}

function fail(what) {
  print "man_page.awk: the help of " name " " what > "/dev/stderr"
  exit 1
}

function indentation(line) {
  return match(line, /[^ ]/) ? RSTART - 1 : 0
}

# "-o [ --output ] FILE" as the page has it: names bold, the value italic.
function tag(words,    value) {
  gsub(/ \[ /, ", ", words)
  gsub(/ \]/, "", words)
  value = ""
  if (match(words, /[^,] [^ -]/)) {
    value = " \\fI" roff(substr(words, RSTART + 2)) "\\fR"
    words = substr(words, 1, RSTART)
  }
  words = roff(words)
  gsub(/, /, "\\fR, \\fB", words)
  return "\\fB" words "\\fR" value
}

# Lines of a description: a wrapped one ends with a blank; one that says more of a format begins with the format's name.
function describe(line, wrapped) {
  if (line ~ /^\.[a-z0-9]/ && !wrapped)
    options = options ".br\n"
  sub(/ +$/, "", line)
  options = options roff(line) "\n"
}

function addOption(line) {
  options = options ".TP\n"
  if (length(line) >= column && substr(line, column, 1) == " ") {
    options = options tag(stripped(substr(line, 1, column))) "\n"
    describe(substr(line, column + 1), 1)
  } else
    options = options tag(stripped(line)) "\n"
}

function stripped(text) {
  gsub(/^ +| +$/, "", text)
  return text
}

function section(title, text) {
  printf ".SH %s\n%s", title, text
}

{ lines[NR] = $0 }

END {
  column = 0 # blanks before descriptions
  for (i = 1; i <= NR && !column; ++i)
    if (indentation(lines[i]) >= 10)
      column = indentation(lines[i])
  for (i = 1; i <= NR && lines[i] != "" && lines[i] !~ /^ /; ++i)
    summary = summary (summary == "" ? "" : " ") lines[i]
  for (; i <= NR; ++i) {
    line = lines[i]
    if (line ~ /^[^ ].*:$/ && lines[i + 1] ~ /^  -/)
      options = options (line == "Options:" ? "" : ".SS " roff(substr(line, 1, length(line) - 1)) "\n")
    else if (line ~ /^  -/)
      addOption(line)
    else if (options != "" && line != "")
      describe(stripped(line) (line ~ / $/ ? " " : ""), lines[i - 1] ~ / $/)
    else if (line ~ /^  / && synopsis == "")
      synopsis = stripped(line)
    else if (line ~ /^  /)
      examples = examples roff(stripped(line)) "\n"
    else if (line != "")
      text = text (text == "" ? "" : " ") line
  }
  ends = index(text, "Exit code: 0 ")
  if (summary == "" || synopsis == "" || options == "" || !ends)
    fail("lacks what it is, a synopsis, options, or \"Exit code: 0 ...\"")
  first = match(summary, /\.( |$)/) ? substr(summary, 1, RSTART - 1) : summary

  printf ".TH %s 1 \"%s\" \"pcl_spiral %s\" \"User Commands\"\n.ad l\n.nh\n", toupper(name), date, version
  section("NAME", name " \\- " roff(first) "\n")
  section("SYNOPSIS", roff(synopsis) "\n")
  section("DESCRIPTION", roff(summary) "\n.PP\n" roff(stripped(substr(text, 1, ends - 1))) "\n")
  section("OPTIONS", options)
  section("EXIT STATUS", roff(substr(text, ends + length("Exit code: "))) "\n")
  if (examples != "")
    section("EXAMPLES", ".nf\n" examples ".fi\n")
  count = split(others, other, " ")
  also = ""
  for (i = 1; i <= count; ++i)
    if (other[i] != name)
      also = also ".BR " roff(other[i]) " (1),\n"
  section("SEE ALSO", also "README.md and the pages beside it, in " roff(docs) " of the installation\n")
}
