// The built book on loopback, as a host on the web serves it: texts compressed, fonts later
// than the text that they set, so that a letter which changes its place is seen.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { setTimeout as later } from "node:timers/promises";
import { promisify } from "node:util";
import { gzip } from "node:zlib";

const compressed = promisify(gzip);
const TEXTS = {
    ".html": "text/html; charset=utf-8", ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8", ".svg": "image/svg+xml", ".json": "application/json",
};
const FONTS_LATE = 150; // ms

/**
 * Serves the directory `root` on a free port and gives `{ origin, close }`. What `change(path,
 * body)` gives is served in its place: how a damaged twin comes about.
 */
export async function served(root, change = (_, body) => body) {
    const kept = new Map();
    const content = async (path) => {
        if (!kept.has(path)) {
            const body = change(path, await readFile(join(root, path)));
            kept.set(path, TEXTS[extname(path)] ? await compressed(body) : body);
        }
        return kept.get(path);
    };
    const server = createServer(async (request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, "http://book").pathname));
        const body = await content(path).catch(() => null);
        if (path.endsWith(".woff2")) await later(FONTS_LATE);
        if (body === null) return response.writeHead(404).end();
        const text = TEXTS[extname(path)];
        const head = text ? { "content-type": text, "content-encoding": "gzip" } : {};
        response.writeHead(200, { ...head, "content-length": body.length }).end(body);
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const origin = `http://127.0.0.1:${server.address().port}`;
    return { origin, close: () => { server.closeAllConnections(); server.close(); } };
}

// ---- Damages.
/** What `damage` makes of the texts whose path matches. */
export const changed = (pattern, damage) => (path, body) => pattern.test(path) ? damage(body.toString()) : body;
/** In a file of the theme, such as `player.js`, `to` for `from`. */
export const instead = (file, from, to) => {
    const [name, extension] = file.split(".");
    return changed(new RegExp(`/${name}-[0-9a-f]+\\.${extension}$`), (text) => {
        if (!text.includes(from)) throw new Error(`${file} does not hold ${from}`);
        return text.replaceAll(from, to);
    });
};
