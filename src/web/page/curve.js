// The curve of the answer: the gradation as the field draws it, and against it the steps of the set of particles.

import { byId } from "./dom.js";
import { drawn, plot } from "./picture.js";
import { readingFlags } from "./question.js";

/** What mdm plot is given for a solution, which was read with these options: words and files. */
function asked({ gradation, answer, answerFile }, options) {
  const hasSet = answer.particles !== null;
  return {
    words: [
      gradation.name, ...(hasSet ? [answerFile.name, "--what", "curve"] : []), "--bands", byId("bands").value,
      ...readingFlags(options),
    ],
    files: { [gradation.name]: gradation.blob, ...(hasSet ? { [answerFile.name]: answerFile.blob } : {}) },
  };
}

/** The curve of this width as an element: {picture, err}; without a picture `err` says why. */
export function curvePicture(solution, options, width) {
  const { words, files } = asked(solution, options);
  return drawn(words, files, width);
}

/** The curve as a file, with title, index numbers and notes: {blob, err}. `flags` are added to the words. */
export function curveFile(solution, options, flags) {
  const { words, files } = asked(solution, options);
  return plot([...words, ...flags], files);
}
