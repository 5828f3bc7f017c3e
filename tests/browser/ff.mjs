import { firefoxAt, chromiumAt, opened } from "./opened.mjs";
import { served } from "./served.mjs";
import { tap } from "./live.mjs";
const book = await served(process.env.BOOK);
const b = process.argv[2] === "c" ? await chromiumAt("/usr/bin/chromium") : await firefoxAt("/usr/bin/firefox-esr");
await opened(b, `${book.origin}/${process.argv[3]}`, { width: 1280 }, async (page) => {
  await page.waitForTimeout(1500); await tap(page);
  const player = page.locator(".player").first();
  await player.locator(".bar").evaluate((bar) => bar.scrollIntoView({ block: "center", behavior: "instant" }));
  const look = () => page.evaluate(() => { const f = document.querySelector(".player").closest("figure"); return [...f.querySelectorAll("*")].filter((e) => e.checkVisibility() && !e.closest("svg *")).map((e) => { const r = e.getBoundingClientRect(); return `${e.tagName}.${e.getAttribute("class") ?? ""} ${r.top.toFixed(1)} ${r.height.toFixed(1)}`; }).concat([`scroll ${scrollY} ${document.documentElement.scrollHeight} ${f.getBoundingClientRect().top}`]); });
  const before = await look();
  await player.locator(".step").first().click();
  await page.waitForTimeout(3000);
  const after = await look(); await page.screenshot({ path: `/tmp/ff_${process.argv[2]}.png` });
  const a = new Set(after); console.log("BEFORE\n" + before.filter((l) => !a.has(l)).slice(0, 30).join("\n"));
  const bb = new Set(before); console.log("AFTER\n" + after.filter((l) => !bb.has(l)).slice(0, 30).join("\n"));
});
await b.close(); book.close(); process.exit(0);
