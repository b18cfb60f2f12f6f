// Pictures that mdm plot draws.

import { pictureElement } from "./svg.js";
import { currentLanguage } from "./texts.js";
import { painter } from "./workers.js";

const LEAST_WIDTH = 200;

/** Runs mdm plot with these words and files in the language of the page. Gives {blob, err}; without a picture the blob is null. */
export async function plot(words, files) {
  const name = "mdm-picture.svg";
  const { files: written, err } = await painter.run(["plot", ...words, "--language", currentLanguage(), "-o", name], files);
  return { blob: written[name] ?? null, err };
}

/** The element of a picture of this width, without what the page says beside it. */
export async function drawn(words, files, width) {
  const { blob, err } = await plot([...words, "--bare", "--width", String(Math.max(LEAST_WIDTH, Math.round(width)))], files);
  return { picture: blob && pictureElement(await blob.text()), err };
}

/** A PNG of an SVG file, with so many pixels for each of its own. */
export async function pngOf(svg, scale = 3) {
  const url = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth * scale;
    canvas.height = image.naturalHeight * scale;
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  } finally {
    URL.revokeObjectURL(url);
  }
}
