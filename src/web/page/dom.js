// Small helpers for the page's elements. Strings become text, never markup.

/** The element with this id. */
export const byId = (id) => document.getElementById(id);

/** A new element with properties and children; `class` and names with a hyphen are attributes. */
export function make(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key === "class" || key.includes("-")) made.setAttribute(key, value);
    else made[key] = value;
  }
  made.append(...children);
  return made;
}

/** Puts the children in the place of all that the element holds; null ones are left out. */
export function fill(parent, ...children) {
  parent.replaceChildren(...children.filter((child) => child !== null));
  parent.hidden = parent.childNodes.length === 0;
}
