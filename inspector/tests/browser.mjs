// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A real Chromium without a window, which may load files and nothing else.

import { existsSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const flags = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
const software_webgl = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";

export const launch = ({ webgl = true } = {}) => {
  if (!existsSync(executablePath))
    throw new Error(`${executablePath} is not there; install chromium, or name it in CHROMIUM`);
  return chromium.launch({
    executablePath,
    headless: true,
    args: [...flags, ...(webgl ? software_webgl : ["--disable-3d-apis"])],
  });
};

/// Opens a page from its file and waits until its scene is shown. page.problems collects what went wrong in it, and
/// every request for anything but the file.
export const open = async (browser, file, options = {}) => {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  const page = await context.newPage();
  page.problems = [];
  page.on("pageerror", (error) => page.problems.push(String(error)));
  page.on("console", (told) => told.type() === "error" && page.problems.push(told.text()));
  page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || page.problems.push(request.url()));
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector("html[data-ready]");
  return page;
};
