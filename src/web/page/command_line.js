// The command line that repeats what the page shows.

/** A word as a shell reads it. */
export function quoted(word) {
  return /^[\w@%+=:,./-]+$/.test(word) ? word : "'" + word.replaceAll("'", "'\\''") + "'";
}

/** The command line that repeats the answer and its check. */
export function commandLine({ gradation, flags, proofName, checkedName }) {
  const solve = ["mdm", "solve", gradation, ...flags, "--proof", proofName];
  const check = ["mdm-check", checkedName, proofName];
  return `${solve.map(quoted).join(" ")} && ${check.map(quoted).join(" ")}`;
}
