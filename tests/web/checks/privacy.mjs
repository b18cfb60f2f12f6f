// No request leaves the page, and its own policy forbids that one does.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";

import { Tab } from "../support.mjs";

/** A server on this machine that counts what comes. */
async function countingServer() {
  const server = createServer((_, response) => {
    server.requests++;
    response.setHeader("Access-Control-Allow-Origin", "*").end("x");
  });
  server.requests = 0;
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { server, address: `http://127.0.0.1:${server.address().port}/` };
}

const leaving = (tab) => tab.requests.filter((one) => !/^(file|blob|data):/.test(one));

async function noRequestLeaves({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.change(() => tab.set("#tolerance-slider", "1"));
  await tab.click("#tradeoff-run");
  await tab.until("the trade-off", () => document.querySelector("#tradeoff-result table") !== null);
  expect(`requests: ${leaving(tab)}`, leaving(tab).length === 0);
  const kept = await tab.page.evaluate(() => document.cookie + localStorage.length + sessionStorage.length);
  expect("no cookies and no storage", kept === "00");

  const { server, address } = await countingServer();
  await tab.page.goto(address);
  expect("a request would have been recorded", leaving(tab).length > 0);
  await tab.close();
  server.close();
}

async function thePolicyForbidsRequests({ expect, open, url }) {
  const { server, address } = await countingServer();
  const tab = await Tab.open(open, url);
  const outcome = await tab.page.evaluate(async (target) => {
    const image = new Image();
    image.src = target + "image";
    navigator.sendBeacon?.(target + "beacon", "x");
    return fetch(target).then(() => "sent", () => "refused");
  }, address);
  await new Promise((resolve) => setTimeout(resolve, 300));
  expect("a request is refused", outcome === "refused");
  expect(`${server.requests} requests came`, server.requests === 0);
  await tab.close();
  server.close();
}

async function thePageNamesNoAddress({ expect, page }) {
  const addresses = [...readFileSync(page, "utf8").matchAll(/(?:src|href|action)\s*=\s*["']?(https?:[^"' >]*)/g)];
  expect(`addresses: ${addresses.map((one) => one[1])}`, addresses.length === 0);
}

export const onPage = [noRequestLeaves, thePolicyForbidsRequests, thePageNamesNoAddress];
