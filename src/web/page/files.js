// Files that come in by choosing and dropping, and go out as downloads.

/** Hands over the files that are dropped on an element. */
export function onDrop(element, take) {
  const mark = (isOver) => element.classList.toggle("over", isOver);
  element.addEventListener("dragover", (event) => {
    event.preventDefault();
    event.stopPropagation();
    mark(true);
  });
  element.addEventListener("dragleave", () => mark(false));
  element.addEventListener("drop", (event) => {
    event.preventDefault();
    event.stopPropagation();
    mark(false);
    if (event.dataTransfer.files.length > 0) take([...event.dataTransfer.files]);
  });
}

/** Hands over the file that is chosen, or all of several; the same file can be chosen again. */
export function onChoice(input, take) {
  input.addEventListener("change", () => {
    const files = [...input.files];
    if (files.length > 0) take(...files);
    input.value = "";
  });
}

/** Saves the text or Blob as a file of this name. */
export function download(name, content) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content]));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

/** The name without what a program or a folder could take for something else. */
export function plainName(name) {
  const base = name.split(/[/\\]/).at(-1).replace(/[\0-\x1f]/g, "");
  return base.replace(/^[-.]+/, "") || "gradation";
}

/** The name without its ending. */
export const stem = (name) => name.replace(/(.)\.[^.]*$/, "$1");

/** A name whose stem differs from the others' stems; commas and signs of equality are of the options that name stockpiles. */
export function freeName(name, taken) {
  const plain = plainName(name).replace(/[,=]/g, "_");
  const base = stem(plain);
  const ending = plain.slice(base.length);
  const isTaken = (one) => taken.some((other) => stem(other) === one);
  let free = base;
  for (let i = 2; isTaken(free); i++) free = `${base}-${i}`;
  return free + ending;
}
