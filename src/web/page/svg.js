// SVG that mdm plot wrote, as an element of the page. Its texts are data: an element or attribute that these pictures do
// not have is refused, so that nothing of them becomes markup.

const SVG = "http://www.w3.org/2000/svg";
const ELEMENTS = ["svg", "g", "path", "circle", "rect", "text", "clipPath"];
const ATTRIBUTES = [
  "width", "height", "viewBox", "role", "font-family", "font-size", "stroke-linejoin", "fill", "stroke", "stroke-width",
  "stroke-dasharray", "d", "cx", "cy", "r", "x", "y", "text-anchor", "transform",
];
/** Ids are of clipping paths alone, of a picture of its own. */
const ID = /^clip\d+$/;
const REFERENCE = /^url\(#(clip\d+)\)$/;

let pictures = 0;

function copyAttribute(copy, { name, value }, prefix) {
  const reference = REFERENCE.exec(value);
  if (name === "id" && ID.test(value)) copy.setAttribute(name, prefix + value);
  else if (name === "clip-path" && reference) copy.setAttribute(name, `url(#${prefix}${reference[1]})`);
  else if (ATTRIBUTES.includes(name) && !/url\(/i.test(value)) copy.setAttribute(name, value);
  else throw new Error(`a picture with the attribute ${name}`);
}

function copied(element, prefix) {
  if (element.namespaceURI !== SVG || !ELEMENTS.includes(element.localName)) {
    throw new Error(`a picture with the element ${element.nodeName}`);
  }
  const copy = document.createElementNS(SVG, element.localName);
  for (const attribute of element.attributes) if (attribute.name !== "xmlns") copyAttribute(copy, attribute, prefix);
  for (const child of element.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) copy.append(child.data);
    else if (!["title", "desc"].includes(child.localName)) copy.append(copied(child, prefix));
  }
  return copy;
}

/** The picture of an SVG file's text as an element; what it shows, in words, is its label. */
export function pictureElement(text) {
  const root = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  const picture = copied(root, `picture${++pictures}-`);
  const words = ["title", "desc"].map((name) => root.querySelector(`:scope > ${name}`)?.textContent);
  picture.setAttribute("aria-label", words.filter((one) => one).join(": "));
  return picture;
}
