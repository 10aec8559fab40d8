# Prints functions of more than `most` lines, from the line that opens the body to the one that closes it, and fails if
# there are any. The sources are formatted: a function of a namespace begins in the first column and ends with a brace of
# its own there. Functions in a class are not seen.
FNR == 1 { begin = 0; name = "" }
!begin && /;$/ { name = ""; next }
!begin && /^(namespace|class|struct|enum|union|using|typedef|extern|#|\/\/|template|\}|$)/ { next }
!begin && /= \{$/ { next }
!begin && /^[A-Za-z_]/ && /\{$/ { begin = FNR; name = $0; next }
!begin && /^[A-Za-z_].*\(/ { name = $0 }
!begin && /^ .*\{$/ && name != "" { begin = FNR; next }
begin && /^\}/ {
  if (FNR - begin - 1 > most) {
    printf "  %s:%d has %d lines: %s\n", FILENAME, begin, FNR - begin - 1, name
    found = 1
  }
  begin = 0
  name = ""
}
END { exit found }
