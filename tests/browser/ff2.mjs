import { firefoxAt, chromiumAt, opened } from "./opened.mjs";
import { served } from "./served.mjs";
const book = await served(process.env.BOOK);
const b = process.argv[2] === "c" ? await chromiumAt("/usr/bin/chromium") : await firefoxAt("/usr/bin/firefox-esr");
await opened(b, `${book.origin}/${process.argv[3]}`, { width: 1280 }, async (page) => {
  await page.waitForTimeout(1500);
  await page.evaluate(() => { for (const fold of document.querySelectorAll("details")) fold.open = true; });
  const player = page.locator(".player").first();
  await player.locator(".bar").evaluate((bar) => bar.scrollIntoView({ block: "center", behavior: "instant" }));
  await page.waitForTimeout(500);
  await page.evaluate(() => { window.log = []; let last = ""; const see = () => { const p = document.querySelector(".player"); const f = p.closest("figure"); const line = [scrollY, p.getBoundingClientRect().top, f.getBoundingClientRect().top, f.querySelector(".panels").offsetHeight, f.querySelector("canvas")?.offsetHeight ?? 0, f.previousElementSibling?.getBoundingClientRect().top, document.documentElement.scrollHeight].map((x) => Number(x).toFixed(1)).join(" "); if (line !== last) log.push(line); last = line; requestAnimationFrame(see); }; see(); });
  await player.locator(".step").first().click();
  await page.waitForTimeout(2500);
  console.log("scrollY player figure panels canvas prev scrollHeight\n" + (await page.evaluate(() => log)).join("\n"));
});
await b.close(); book.close(); process.exit(0);
