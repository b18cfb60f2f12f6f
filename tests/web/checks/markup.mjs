// Names and ids with markup in them are text: on the page, in the report and in the picture.

import { readFileSync } from "node:fs";

import { ROOT, Tab, fileOf } from "../support.mjs";

const MARKUP = '<img src=x onerror="window.hurt=1"><b>sand<b>';

async function markupStaysText({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.page.evaluate(() => {
    window.print = () => (window.printed = true);
  });
  const gradation = JSON.stringify({ id: `"><script>window.hurt=1</script>${MARKUP}`, sizes: ["1", "2", "3"], masses: ["2", "1", "0"] });
  await tab.gradation(fileOf(`${MARKUP}.json`, gradation));
  await tab.click("#print");
  await tab.until("the report", () => window.printed);
  const found = await tab.page.evaluate(() => ({
    hurt: window.hurt,
    elements: document.querySelectorAll("main img, main b, main script, .report img, .report b, .report script").length,
    report: document.querySelector("#report").textContent,
    label: document.querySelector("#curve svg").getAttribute("aria-label"),
  }));
  expect("nothing ran", found.hurt === undefined);
  expect("no element was made", found.elements === 0);
  expect("the report shows the id", found.report.includes("<script>window.hurt=1</script>"));
  expect("the picture's label shows the id", found.label.includes(MARKUP));
  expect("the name is shown", (await tab.text("#file-name")).includes("<b>sand<b>"));

  await tab.gradation(fileOf("plain.json", gradation));
  const svg = readFileSync(await tab.download('[data-download="svg"]', "plain.svg"), "utf8");
  expect("the SVG file has the id as text", svg.includes("&lt;script&gt;window.hurt=1") && !svg.includes("<script"));

  await tab.gradation(fileOf("bad.csv", `size_mm,mass\n1,${MARKUP}\n2,0\n`));
  expect("a message shows it", (await tab.text("#message pre")).includes("<img src=x"));
  const after = await tab.page.evaluate(() => [typeof window.hurt, document.querySelectorAll("main img").length]);
  expect("a message runs nothing", after[0] === "undefined" && after[1] === 0);
  await tab.close();
}

const INSIDE = (inner, more = "") =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"${more}>${inner}</svg>`;

const REFUSED = [
  INSIDE("<script>window.hurt=1</script>"),
  INSIDE("", ' onload="window.hurt=1"'),
  INSIDE('<path d="M0 0" onclick="window.hurt=1"/>'),
  INSIDE('<a href="javascript:window.hurt=1"><text>x</text></a>'),
  INSIDE('<g xmlns:xlink="http://www.w3.org/1999/xlink" xlink:href="#x"/>'),
  INSIDE('<g><image href="https://example.org/x.png"/></g>'),
  INSIDE('<foreignObject><b xmlns="http://www.w3.org/1999/xhtml">x</b></foreignObject>'),
  INSIDE('<text xmlns="http://www.w3.org/1999/xhtml">x</text>'),
  INSIDE("<style>text { fill: red }</style>"),
  INSIDE('<rect style="fill: red"/>'),
  INSIDE('<rect fill="url(https://example.org/x.svg#a)"/>'),
  INSIDE('<g clip-path="url(https://example.org/x.svg#clip1)"/>'),
  INSIDE('<g id="question"/>'),
  INSIDE("<!-- a comment -->"),
  INSIDE("<g>"),
  "<html xmlns='http://www.w3.org/1999/xhtml'/>",
  "",
];

/** The page's own reader of pictures is given what mdm plot never writes. */
async function picturesWithMoreAreRefused({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const source = readFileSync(`${ROOT}src/web/page/svg.js`, "utf8").replaceAll("export ", "");
  const read = (texts) => tab.page.evaluate(`(() => {
    ${source}
    return ${JSON.stringify(texts)}.map((one) => {
      try {
        return pictureElement(one).outerHTML;
      } catch {
        return null;
      }
    });
  })()`);
  const refused = await read(REFUSED);
  refused.forEach((made, i) => expect(`${REFUSED[i]} is refused, not ${made}`, made === null));
  expect("nothing ran", (await tab.page.evaluate(() => window.hurt)) === undefined);
  const clip = '<clipPath id="clip1"><rect x="1" y="1" width="2" height="2"/></clipPath><g clip-path="url(#clip1)"/>';
  const [first, second] = await read([INSIDE(`<title>a</title><desc>b</desc>${clip}<text>&lt;b&gt;</text>`), INSIDE(clip)]);
  expect(`${first}: its label and its text`, first.includes('aria-label="a: b"') && first.includes("&lt;b&gt;</text>"));
  const idOf = (one) => /id="([^"]*)"/.exec(one)[1];
  expect("ids of pictures differ", idOf(first) !== idOf(second) && first.includes(`url(#${idOf(first)})`));
  await tab.close();
}

export const onPage = [markupStaysText, picturesWithMoreAreRefused];
