# awk -v page=mdm-solve -v version=0.2.0 -f man_page.awk: the text of a --help as a page in roff, for man.
#
# The help has a sentence and `Usage: ...`, or the usages alone in its first lines; headings that end with a colon over
# entries that are indented by two spaces; paragraphs, and commands below `Example:` or `Examples:`.

{ line[++lines] = $0 }

# Text that roff takes as it is.
function plain(text) {
  gsub(/\\/, "\\(rs", text)
  gsub(/-/, "\\-", text)
  gsub(/'/, "\\(aq", text)
  gsub(/`/, "\\(ga", text)
  gsub(/\^/, "\\(ha", text)
  gsub(/~/, "\\(ti", text)
  return text
}

function put(text) { print (text ~ /^[.]/ ? "\\&" : "") plain(text) }

function is_heading(i) { return line[i] ~ /^[A-Z].*:$/ && line[i + 1] ~ /^  [^ ]/ }

function is_deep(i) { return line[i] ~ /^      +[^ ]/ }

# An entry, which begins at line i: a name, and its text behind the name or on the lines below it. Returns the line
# after it.
function put_entry(i,    name, text) {
  name = substr(line[i], 3)
  if (match(name, /  +/)) {
    text = substr(name, RSTART + RLENGTH)
    name = substr(name, 1, RSTART - 1)
  } else if (!is_deep(i + 1) && length(name) > 28) {
    text = substr(name, 29)
    name = substr(name, 1, 27)
  }
  for (++i; i <= lines && is_deep(i); ++i) {
    sub(/^ +/, "", line[i])
    text = text (text == "" ? "" : " ") line[i]
  }
  print ".TP\n\\fB" plain(name) "\\fR"
  put(text)
  return i
}

function put_command(text) {
  sub(/^ */, "", text)
  examples = examples plain(text) "\n"
}

END {
  for (i = 1; i <= lines && line[i] !~ /^Usage: /; ++i)
    ;
  if (i <= lines) {
    summary = line[1]
    usage = substr(line[i], 8)
    begin = i + 1
  } else {
    usage = line[1]
    for (i = 2; i <= lines && line[i] != ""; ++i)
      other_usages = other_usages "\n.br\n\\fB" plain(line[i]) "\\fR"
    for (; line[i] == ""; ++i)
      ;
    begin = i
    for (; line[i] != "" && summary !~ /\.$/; ++i)
      summary = summary (summary == "" ? "" : " ") line[i]
  }
  sub(/\.$/, "", summary)
  summary = tolower(substr(summary, 1, 1)) substr(summary, 2)

  print ".TH " toupper(plain(page)) " 1 \"\" \"exactmdm " version "\" exactmdm"
  print ".SH NAME\n" plain(page) " \\- " plain(summary)
  print ".SH SYNOPSIS\n\\fB" plain(usage) "\\fR" other_usages

  described = 0
  for (i = begin; i <= lines;) {
    if (line[i] == "") {
      paragraph = described
      ++i
    } else if (line[i] ~ /^Examples?:$/) {
      for (++i; line[i] ~ /^ /; ++i)
        put_command(line[i])
    } else if (is_heading(i)) {
      print ".SH " toupper(plain(substr(line[i], 1, length(line[i]) - 1)))
      if (line[i] == "Subcommands:")
        for (j = i + 1; line[j] ~ /^  [^ ]/; ++j) {
          split(line[j], word, " ")
          see = see ".BR " plain(page "-" word[1]) " (1),\n"
        }
      described = 0
      for (++i; line[i] ~ /^  [^ ]/;)
        i = put_entry(i)
    } else if (line[i] ~ /^  -/) {
      print ".SH OPTIONS"
      while (line[i] ~ /^  [^ ]/)
        i = put_entry(i)
    } else if (line[i] ~ /^Example: /) {
      put_command(substr(line[i], 10))
      for (++i; line[i] ~ /^  +[^ ]/; ++i)
        put_command(line[i])
    } else {
      if (!described)
        print ".SH DESCRIPTION"
      else if (paragraph)
        print ".PP"
      paragraph = 0
      described = 1
      put(line[i++])
    }
  }
  if (examples != "")
    printf ".SH EXAMPLES\n.nf\n%s.fi\n", examples
  print ".SH SEE ALSO"
  if (page == "mdm-check")
    print ".BR mdm (1)"
  else
    printf "%s.BR mdm\\-check (1)\n", (page == "mdm" ? see : ".BR mdm (1),\n")
}
